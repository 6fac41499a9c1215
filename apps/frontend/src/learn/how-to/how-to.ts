/**
 * Block of a how-to page. `{origin}` and `{host}` are replaced by the URL of this master. Texts of the interface are
 * `**bold**`: a test finds each of them in the sources of the pages.
 */
export type HowToBlock =
  | { readonly kind: 'text'; readonly text: string }
  | { readonly kind: 'steps'; readonly steps: readonly string[] }
  | { readonly kind: 'code'; readonly label: string; readonly code: string }
  | { readonly kind: 'link'; readonly text: string; readonly to: string };

export interface HowTo {
  /** Part of the URL. */
  readonly id: string;
  readonly title: string;
  readonly intro: string;
  readonly blocks: readonly HowToBlock[];
}
