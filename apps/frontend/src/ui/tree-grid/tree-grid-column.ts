/** A column of a tree grid. */
export interface TreeGridColumn<K extends string> {
  readonly name: string;
  /** CSS class of its heading. */
  readonly place: string;
  /** Left-aligned text; otherwise a right-aligned number. */
  readonly isText?: boolean | undefined;
  /** Sort criterion; without it, the heading is not a button. */
  readonly sortKey?: K | undefined;
  /** Current direction of sorting by it. */
  readonly sorted?: 'ascending' | 'descending' | undefined;
  /** Tooltip that explains the numbers. */
  readonly title?: string | undefined;
  /** Number of grid columns that the heading spans. @default 1 */
  readonly span?: number | undefined;
  /** Visually hidden heading. */
  readonly isHidden?: boolean | undefined;
}
