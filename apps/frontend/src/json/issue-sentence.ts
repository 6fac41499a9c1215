import type { BaseIssue } from 'valibot';

type Issue = BaseIssue<unknown>;

/** Formats the length of a text or list, which issues report as a number. */
const withLength = ({ input }: Issue, limit: string): string =>
  typeof input === 'string' ? `a text of ${limit} characters` : `a list of ${limit} elements`;

/** Converts `("a" | "b")` to `"a" or "b"`. */
const alternatives = ({ expected }: Issue): string =>
  (expected ?? '').replace(/^\((.*)\)$/, '$1').replaceAll(' | ', ' or ');

/** Expected value, by the type of a valibot issue. */
const EXPECTED: Readonly<Record<string, (issue: Issue) => string>> = {
  string: () => 'a text',
  number: () => 'a number',
  finite: () => 'a number',
  integer: () => 'a whole number',
  boolean: () => 'true or false',
  array: () => 'a list',
  object: () => 'an object',
  record: () => 'an object',
  literal: alternatives,
  picklist: alternatives,
  union: alternatives,
  variant: alternatives,
  min_value: ({ requirement }) => `${String(requirement)} or more`,
  max_value: ({ requirement }) => `${String(requirement)} or less`,
  max_length: (issue) => withLength(issue, `up to ${String(issue.requirement)}`),
  min_length: (issue) => withLength(issue, `${String(issue.requirement)} or more`),
};

/** Path such as `results[0].findings`; empty for the whole value. */
function placeOf({ path }: Issue): string {
  const steps = path?.map(({ key }) => (typeof key === 'number' ? `[${key}]` : `.${String(key)}`));
  return (steps ?? []).join('').replace(/^\./, '');
}

/**
 * Formats an issue as a sentence: `results[0].startedMs should be a number.` Messages of a schema that end with a full
 * stop are complete; others follow the path.
 */
export function issueSentence(issue: Issue): string {
  if (issue.message.endsWith('.')) return issue.message;
  const place = placeOf(issue) || 'The content';
  if (issue.message !== '') return `${place} ${issue.message}.`;
  if (issue.received === 'undefined') return `${place} is missing.`;
  return `${place} should be ${EXPECTED[issue.type]?.(issue) ?? 'another value'}.`;
}
