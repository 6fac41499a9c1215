import { compileGlob } from '@ubii/patterns';
import type { PersonalLabel } from '@ubii/proto';
import type { PersonalRules } from '@ubii/recording/personal';
import { counted, plural } from '@ubii/words';
import { isOwn, type RecordedTopic } from '../timeline/track.ts';

/** How personal data is replaced in an export. */
export interface PersonalChoice {
  readonly rules: PersonalRules;
  /** Content of a key file; undefined for a new key. */
  readonly key: string | undefined;
}

/** Labels of the file and of the master, each once: those of the master are newer. */
export function allLabels(
  ofFile: readonly PersonalLabel[],
  ofMaster: readonly PersonalLabel[],
): readonly PersonalLabel[] {
  const known = new Set(ofMaster.map(({ id }) => id));
  return [...ofMaster, ...ofFile.filter(({ id }) => !known.has(id))];
}

/** How many of these topics a pattern selects. */
export function matchCount(pattern: string, topics: Iterable<string>): number {
  const matches = compileGlob(pattern);
  let count = 0;
  for (const topic of topics) if (matches(topic)) count++;
  return count;
}

/** What will be replaced, and what is left out. */
export function previewOf(
  topics: readonly RecordedTopic[],
  labels: readonly PersonalLabel[],
): string {
  const names = new Set(topics.map(({ topic }) => topic));
  const foreign = new Set(topics.filter((one) => !isOwn(one)).map(({ topic }) => topic)).size;
  const clients = new Set(topics.map(({ clientId }) => clientId).filter((id) => id !== ''));
  const applied = labels.filter(({ topicPattern }) => matchCount(topicPattern, names) > 0);
  const globs = applied.map(({ topicPattern }) => compileGlob(topicPattern));
  const labelled = [...names].filter((topic) => globs.some((matches) => matches(topic))).length;
  const verb = plural(applied.length, 'applies', 'apply');
  return [
    `${counted(clients.size, 'client')} will have pseudonyms.`,
    applied.length === 0
      ? 'No label matches a topic of this recording.'
      : `${counted(applied.length, 'label')} ${verb} to ${counted(labelled, 'topic')}.`,
    foreign === 0
      ? ''
      : `${counted(foreign, 'topic')} with messages of other programs ${plural(foreign, 'is', 'are')} left out, because they cannot be searched for names.`,
  ]
    .filter(Boolean)
    .join(' ');
}
