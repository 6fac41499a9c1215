import { readFile, writeFile } from 'node:fs/promises';
import { ConfigError } from '@ubii/program';
import type { EventsReader } from '@ubii/recording';
import {
  createPseudonymKey,
  createTreatment,
  findPeople,
  formatPseudonymKey,
  labelsOf,
  parsePersonalRules,
  parsePseudonymKey,
  Pseudonyms,
  SHARING_RULES,
  TreatedReader,
  type PersonalRules,
  type PseudonymKey,
} from '@ubii/recording/personal';

/** A recording as it is exported. */
export interface SharedRecording {
  readonly reader: EventsReader;
  /** Returns a topic as it is exported; undefined when it is dropped. */
  topic(topic: string): string | undefined;
  /** What was found of labelled values in what was read so far, as sentences without their ends. [PD-18] */
  report(): readonly string[];
  /** Writes the key file, once everything was read. */
  saveKey(): Promise<void>;
}

/** @param personal `none`, `recording`, or a file with rules @param keyPath empty to throw the key away */
export async function shareRecording(
  reader: EventsReader,
  personal: string,
  keyPath: string,
): Promise<SharedRecording> {
  if (personal === 'none') {
    const saveKey = (): Promise<void> => Promise.resolve();
    return { reader, topic: (topic) => topic, report: () => [], saveKey };
  }
  const rules = await asConfig(() => rulesOf(reader, personal));
  const key = await asConfig(() => keyOf(keyPath));
  const pseudonyms = new Pseudonyms(key);
  const treatment = createTreatment(rules, await findPeople(reader, rules.labels), pseudonyms);
  return {
    reader: new TreatedReader(reader, treatment),
    topic: (topic) => treatment.topic(topic),
    report: () => treatment.report(),
    async saveKey() {
      if (keyPath === '') return;
      // Whoever reads it knows the people.
      await writeFile(keyPath, formatPseudonymKey(pseudonyms.key), { mode: 0o600 });
    },
  };
}

async function rulesOf({ summary }: EventsReader, personal: string): Promise<PersonalRules> {
  if (personal === 'recording') return { ...SHARING_RULES, labels: labelsOf(summary) };
  return parsePersonalRules(await readFile(personal, 'utf8'));
}

async function keyOf(path: string): Promise<PseudonymKey> {
  const create = (): PseudonymKey => createPseudonymKey((bytes) => crypto.getRandomValues(bytes));
  if (path === '') return create();
  try {
    return parsePseudonymKey(await readFile(path, 'utf8'));
  } catch (error) {
    if ((error as NodeJS.ErrnoException).code === 'ENOENT') return create();
    throw error;
  }
}

async function asConfig<T>(read: () => Promise<T>): Promise<T> {
  try {
    return await read();
  } catch (error) {
    throw error instanceof Error ? new ConfigError(error.message) : error;
  }
}
