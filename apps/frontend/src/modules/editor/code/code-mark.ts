import type { TextPlace } from '../text/module-text.ts';

/** Something to be seen at a place of the text. */
export interface CodeMark extends TextPlace {
  readonly severity: 'error' | 'warning';
  readonly message: string;
}
