/** A row of a tree grid. */
export interface TreeGridRow {
  /** Of the whole tree, and stays the same while the thing is there. */
  readonly key: string;
  /** 1 for a root. */
  readonly level: number;
  /** From 1, among its siblings. */
  readonly position: number;
  readonly setSize: number;
}

/** What the element of a row needs to be one for assistive technology, the keyboard and the focus. */
export interface TreeGridRowAttributes {
  readonly role: 'row';
  readonly 'aria-rowindex': number;
  readonly 'aria-level': number;
  readonly 'aria-posinset': number;
  readonly 'aria-setsize': number;
  readonly 'aria-expanded': boolean | undefined;
  readonly 'aria-selected': boolean | undefined;
  readonly tabindex: 0 | -1;
  readonly 'data-key': string;
}
