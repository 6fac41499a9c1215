/**
 * Gives the source code in an element the colours of its language, in the theme of the page. The first call loads what it needs.
 *
 * @returns ends following the theme
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
