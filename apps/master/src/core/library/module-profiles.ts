import { parseDataFormat, type ModuleIO, type ProcessingModule } from '@ubii/proto';

/** Whether a module has everything a profile asks for; empty members ask for nothing [SE-22] [CL-20]. */
export function matchesModule(module: ProcessingModule, profile: ProcessingModule): boolean {
  return (
    (profile.id === '' || module.id === profile.id) &&
    (profile.name === '' || module.name === profile.name) &&
    (profile.nodeId === '' || module.nodeId === profile.nodeId) &&
    (profile.sessionId === '' || module.sessionId === profile.sessionId) &&
    profile.authors.every((author) => module.authors.includes(author)) &&
    profile.tags.every((tag) => module.tags.includes(tag)) &&
    hasFormats(module.inputs, profile.inputs) &&
    hasFormats(module.outputs, profile.outputs)
  );
}

/** For each input or output asked for there is one of its own with the same data format. */
function hasFormats(has: readonly ModuleIO[], wanted: readonly ModuleIO[]): boolean {
  const rest = has.map(({ messageFormat }) => formatKey(messageFormat));
  return wanted.every(({ messageFormat }) => {
    const index = rest.indexOf(formatKey(messageFormat));
    if (index >= 0) rest.splice(index, 1);
    return index >= 0;
  });
}

/** Spellings of one data format are the same. */
function formatKey(text: string): string {
  return parseDataFormat(text) ?? text;
}
