/** What the key beside the space bar is called on this machine. */
export function modifierKey(platform: string = navigator.platform): string {
  return /Mac|iPhone|iPad/.test(platform) ? '⌘' : 'Ctrl';
}
