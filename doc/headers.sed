# The public headers as Doxygen wants them: their comments are plain, above what they speak of or behind it.
s,\[\[nodiscard\]\] ,,
\,^ *//,s,\\,\\\\,g
s,^( *)//( |$),\1///\2,
s,([^ ] +)// ,\1///< ,
# What is compiled elsewhere is declared already.
/^extern template/,/;/d
