/** The formulas of a file in pieces of MathML, by their names (bundle/formulas.ts). */
declare module '*.tex' {
  const formulas: Readonly<Record<string, readonly string[]>>
  export default formulas
}
