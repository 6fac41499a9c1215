/** Text of the button that starts a session: starting saves unsaved changes first. */
export function startText(canResume: boolean, changes: number): string {
  const word = canResume ? 'resume' : 'start';
  if (changes > 0) return `Save and ${word}`;
  return canResume ? 'Resume' : 'Start';
}
