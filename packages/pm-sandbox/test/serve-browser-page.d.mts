/** Serves a page that runs modules in the sandboxes of browsers, with the policies a master sends. */
export function serveBrowserPage(): Promise<{
  readonly url: string;
  /** Paths that were asked for. */
  readonly requests: string[];
  close(): void;
}>;
