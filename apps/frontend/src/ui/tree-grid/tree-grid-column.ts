/** A column of a tree grid. */
export interface TreeGridColumn<K extends string> {
  readonly name: string;
  /** Class of its header. */
  readonly place: string;
  /** Texts stand on the left, numbers on the right. */
  readonly isText?: boolean | undefined;
  /** By what its header orders the rows; without it, the header is no button. */
  readonly sortKey?: K | undefined;
  /** How the rows are ordered by it now. */
  readonly sorted?: 'ascending' | 'descending' | undefined;
  /** What the numbers are, as a tooltip. */
  readonly title?: string | undefined;
  /** Tracks of the grid that the header takes. @default 1 */
  readonly span?: number | undefined;
  /** The name is for assistive technology alone. */
  readonly isHidden?: boolean | undefined;
}
