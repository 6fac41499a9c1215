/** A demuxer's format, taken apart. */
export interface DemuxFormat {
  readonly parts: readonly DemuxPart[];
}

type DemuxPart =
  | { readonly kind: 'text'; readonly text: string }
  | { readonly kind: 'param'; readonly index: number }
  | { readonly kind: 'identity' };

/** The topic of an element, or what it lacks, as a sentence without its end. */
export type DemuxTopic = { readonly topic: string } | { readonly lacks: string };

const NUMBERED = /\{\{#(\d+)\}\}|\{\{identity\}\}/g;
/** Older sessions number nothing: each `%s` is the next parameter. */
const SEQUENTIAL = /%s|\{\{identity\}\}/g;

/** Takes a demuxer's `output_topic_format` apart. [PM-45] */
export function parseDemuxFormat(format: string): DemuxFormat {
  const isNumbered = /\{\{#\d+\}\}/.test(format);
  const parts: DemuxPart[] = [];
  let end = 0;
  let nextParam = 0;
  for (const match of format.matchAll(isNumbered ? NUMBERED : SEQUENTIAL)) {
    if (match.index > end) parts.push({ kind: 'text', text: format.slice(end, match.index) });
    end = match.index + match[0].length;
    if (match[0] === '{{identity}}') parts.push({ kind: 'identity' });
    else parts.push({ kind: 'param', index: isNumbered ? Number(match[1]) : nextParam++ });
  }
  if (end < format.length) parts.push({ kind: 'text', text: format.slice(end) });
  return { parts };
}

/** Whether elements can be distinguished at all: the format has a placeholder. [SE-4] */
export function hasPlaceholder(format: DemuxFormat): boolean {
  return format.parts.some(({ kind }) => kind !== 'text');
}

/**
 * The topic of one element. Parameters are put in as they are. [PM-45] [PM-46]
 *
 * @param params undefined when the element has none; then its identity is the only one
 */
export function demuxTopic(
  format: DemuxFormat,
  params: readonly string[] | undefined,
  identity: string | undefined,
): DemuxTopic {
  const given = params ?? (identity === undefined ? [] : [identity]);
  let topic = '';
  for (const part of format.parts) {
    if (part.kind === 'text') {
      topic += part.text;
      continue;
    }
    const value = part.kind === 'identity' ? identity : given[part.index];
    // [PM-47]
    if (value === undefined) return { lacks: lack(part, given.length) };
    topic += value;
  }
  return { topic };
}

function lack(part: Exclude<DemuxPart, { kind: 'text' }>, count: number): string {
  if (part.kind === 'identity') return 'the topic needs an identity. Set identity';
  const given = count === 0 ? 'outputTopicParams has none' : `outputTopicParams has ${count}`;
  return `the topic needs the parameter ${part.index}, ${given}`;
}
