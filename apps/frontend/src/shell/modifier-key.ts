/** Returns the name of the modifier key of shortcuts on this computer. */
export function modifierKey(platform: string = navigator.platform): string {
  return /Mac|iPhone|iPad/.test(platform) ? '⌘' : 'Ctrl';
}
