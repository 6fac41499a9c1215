/** Returns the keys after which Tab leaves the code editor, as Monaco binds them on this computer. */
export function leaveKeys(platform: string = navigator.platform): string {
  return /Mac|iPhone|iPad/.test(platform) ? 'Ctrl Shift M' : 'Ctrl M';
}
