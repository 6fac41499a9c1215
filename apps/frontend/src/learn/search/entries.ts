import { HOW_TOS } from '../how-to/how-tos.ts';
import { LESSONS } from '../lessons/lessons.ts';
import { entryId, REFERENCE_PAGES } from '../reference/reference-pages.ts';
import type { SearchEntry } from './search.ts';

/** All entries of `/learn`: lessons with their steps, how-tos, and the reference. */
export const SEARCH_ENTRIES: readonly SearchEntry[] = [
  ...LESSONS.map(({ id, title, intro, steps }) => ({
    title,
    detail: [intro, ...steps.flatMap((step) => [step.title, step.text])].join(' '),
    kind: 'Lesson',
    to: `/learn/${id}`,
  })),
  ...HOW_TOS.map(({ id, title, intro, blocks }) => ({
    title,
    detail: [intro, ...blocks.flatMap((block) => (block.kind === 'text' ? [block.text] : []))].join(
      ' ',
    ),
    kind: 'How to',
    to: `/learn/how-to/${id}`,
  })),
  ...REFERENCE_PAGES.flatMap((page) =>
    page.sections.flatMap(({ entries }) =>
      entries.map(({ name, sentence }) => ({
        title: name,
        detail: sentence,
        kind: page.title,
        to: `/learn/reference/${page.id}#${entryId(name)}`,
      })),
    ),
  ),
];
