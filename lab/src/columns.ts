// A table of numbers: what is shown behind a chart, and what a file of it holds.

export interface Column {
  readonly title: string
  readonly values: Float64Array
  /** From the unit of the data to that of the table. */
  readonly factor: number
  readonly decimals: number
  /** Significant ones instead, where sizes differ much. */
  readonly digits?: number
  /** What its line in the plot wears: the picture that is saved has a key of these. */
  readonly clothes?: string
  /** Its formula, or what it is: for the header of a file. */
  readonly about?: string
}

export interface TableSpec {
  readonly caption: string
  /** Name of the file, without its ending. */
  readonly file: string
  readonly first: Column
  readonly columns: readonly Column[]
  /** Rows of the short table; else some at even distances. */
  readonly some?: readonly number[]
}
