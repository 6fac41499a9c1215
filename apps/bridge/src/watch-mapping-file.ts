import { readFileSync, unwatchFile, watchFile } from 'node:fs';
import { ConfigError } from '@ubii/program';
import type { Protocol } from './core/mapping/mapping.ts';
import { readMappingFile } from './core/mapping/read-mapping-file.ts';
import type { MappingFile } from './core/mapping/read-mapping-file.ts';

const POLL_MS = 500;

const EXAMPLE = `{
  "version": 1,
  "mappings": [
    { "direction": "in", "foreign": "sensors/+/temp", "topic": "/mqtt/{1}/temp", "format": "double" }
  ]
}`;

/** @throws ConfigError with the file and what is wrong with it */
export function loadMappingFile(file: string, protocol: Protocol): MappingFile {
  let text: string;
  try {
    text = readFileSync(file, 'utf8');
  } catch (error) {
    const { code, message } = error as NodeJS.ErrnoException;
    if (code !== 'ENOENT') {
      throw new ConfigError(`The mapping file ${file} (--mapping) cannot be read: ${message}.`);
    }
    throw new ConfigError(
      `The mapping file ${file} (--mapping) does not exist. Create it, for example:\n${EXAMPLE}`,
    );
  }
  try {
    return readMappingFile(text, protocol);
  } catch (error) {
    throw new ConfigError(`${file}: ${(error as Error).message}`);
  }
}

/** Calls one of the functions after each change of the file. A file that is wrong changes nothing. [BR-4] @returns ends it */
export function watchMappingFile(
  file: string,
  protocol: Protocol,
  events: { onChange(mapping: MappingFile): void; onError(message: string): void },
): () => void {
  const listener = (): void => {
    let read: MappingFile;
    try {
      read = loadMappingFile(file, protocol);
    } catch (error) {
      return events.onError((error as Error).message);
    }
    events.onChange(read);
  };
  // Asks for the file again and again: editors replace files, and not all systems tell of that.
  watchFile(file, { interval: POLL_MS, persistent: false }, listener);
  return () => unwatchFile(file, listener);
}
