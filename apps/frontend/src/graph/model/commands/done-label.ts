/** Past tense of the verbs in labels of commands. */
const DONE: Readonly<Record<string, string>> = {
  Add: 'Added',
  Arrange: 'Arranged',
  Bypass: 'Bypassed',
  Change: 'Changed',
  Collapse: 'Collapsed',
  Colour: 'Coloured',
  Connect: 'Connected',
  Delete: 'Deleted',
  Detach: 'Detached',
  Disconnect: 'Disconnected',
  Duplicate: 'Duplicated',
  Edit: 'Edited',
  Expand: 'Expanded',
  Frame: 'Framed',
  Insert: 'Inserted',
  Keep: 'Kept',
  Move: 'Moved',
  Mute: 'Muted',
  Paste: 'Pasted',
  Remove: 'Removed',
  Reroute: 'Rerouted',
  Resize: 'Resized',
  Show: 'Showed',
  Use: 'Enabled',
};

/** Label of a completed command: `Connected pointer to mirror · position`. */
export function doneLabel(label: string): string {
  const [verb = '', ...rest] = label.split(' ');
  return [Object.hasOwn(DONE, verb) ? DONE[verb] : verb, ...rest].join(' ');
}
