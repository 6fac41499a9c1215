import { capitalised } from '@ubii/words';
import type * as v from 'valibot';

/** What is wrong with a mapping: at which of its members, and in words. [BR-1] */
export class MappingFault extends Error {
  /** Member of the mapping; empty for the mapping as a whole. */
  readonly member: string;
  /** One sentence for a view that shows the member. */
  readonly words: string;

  /** @param rest of the sentence after the place of the mapping; default: after the member */
  constructor(
    member: string,
    words: string,
    rest = `${member === '' ? '' : `.${member}`}: ${words}`,
  ) {
    super(rest);
    this.member = member;
    this.words = capitalised(words);
  }
}

/** The fault that an issue of the schema stands for: ` must be 0, 1 or 2, but is 3.` */
export function faultOf(issue: v.BaseIssue<unknown>): MappingFault {
  const steps = issue.path?.map(({ key }) => String(key)) ?? [];
  const predicate = predicateOf(issue, steps.length === 0);
  const rest = `${steps.map((step) => `.${step}`).join('')} ${predicate}`;
  const words = predicate === 'is missing.' ? 'Enter a value.' : predicate;
  return new MappingFault(steps[0] ?? '', words, rest);
}

/** What follows the place of an issue: `must be 0, 1 or 2, but is 3.` */
export function predicateOf(issue: v.BaseIssue<unknown>, isWhole: boolean): string {
  if (issue.type === 'strict_object' && issue.expected === 'never') {
    return 'is unknown. Check how it is written, or remove it.';
  }
  if (issue.type === 'strict_object' && issue.received === 'undefined') return 'is missing.';
  if (issue.type === 'strict_object' && isWhole) return 'must be an object.';
  return `${issue.message}, but is ${JSON.stringify(issue.input)?.slice(0, 100) ?? 'missing'}.`;
}
