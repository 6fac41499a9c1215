import type { monaco as Monaco } from './monaco.ts';

/**
 * Highlights the source code in an element, in the theme of the page. Loads the highlighter on first use.
 *
 * @returns a function that stops following the theme
 */
export async function colorSource(element: HTMLElement): Promise<() => void> {
  const { monaco, end } = await openHighlighter();
  await monaco.editor.colorizeElement(element, { theme: 'ubii', mimeType: 'text/typescript' });
  return end;
}

/**
 * Highlights JavaScript line by line. Loads the highlighter on first use.
 *
 * @returns the HTML of each line, and a function that stops following the theme
 */
export async function colorLines(
  source: string,
): Promise<{ readonly lines: readonly string[]; readonly end: () => void }> {
  const { monaco, end } = await openHighlighter();
  const html = await monaco.editor.colorize(source, 'javascript', { tabSize: 2 });
  return { lines: htmlLines(html), end };
}

/** Returns the lines of Monaco's HTML, with spaces at which they wrap: Monaco writes spaces that do not break. */
export function htmlLines(html: string): readonly string[] {
  return html.replace(/&#160;|&nbsp;|\u00a0/g, ' ').split('<br/>');
}

async function openHighlighter(): Promise<{
  readonly monaco: typeof Monaco;
  readonly end: () => void;
}> {
  const [{ monaco }, { followTheme }] = await Promise.all([
    import('./monaco.ts'),
    import('./monaco-theme.ts'),
  ]);
  return { monaco, end: followTheme() };
}
