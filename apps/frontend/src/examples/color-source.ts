/**
 * Highlights the source code in an element, in the theme of the page. Loads the highlighter on first use.
 *
 * @returns a function that stops following the theme
 */
export async function colorSource(element: HTMLElement): Promise<() => void> {
  const [{ monaco }, { followTheme }] = await Promise.all([
    import('../modules/editor/code/monaco.ts'),
    import('../modules/editor/code/monaco-theme.ts'),
  ]);
  const end = followTheme();
  await monaco.editor.colorizeElement(element, { theme: 'ubii', mimeType: 'text/typescript' });
  return end;
}
