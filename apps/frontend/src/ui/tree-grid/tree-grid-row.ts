/** A row of a tree grid. */
export interface TreeGridRow {
  /** Unique in the tree, and stable while the element exists. */
  readonly key: string;
  /** 1 for a root. */
  readonly level: number;
  /** Position among its siblings, from 1. */
  readonly position: number;
  readonly setSize: number;
}

/** Attributes of a row's element for assistive technology, keyboard and focus. */
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
