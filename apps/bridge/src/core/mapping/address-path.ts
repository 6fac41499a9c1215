/** One level of a pattern. */
interface Level {
  /** Text, or what stands before the captured text. */
  readonly before: string;
  /** Number of the text that is captured here. */
  readonly capture: number | undefined;
  readonly after: string;
  /** This level and all below it are captured. */
  readonly isRest: boolean;
}

/** A pattern of topics or addresses, level by level. */
export interface AddressPath {
  /** As written in the mapping. */
  readonly text: string;
  readonly levels: readonly Level[];
}

/** What is captured, by number. */
export type Captures = ReadonlyMap<number, string>;

/** How the wildcards of one side are written. */
interface Wildcards {
  readonly one: string;
  readonly rest: string;
}

const FOREIGN: Wildcards = { one: '+', rest: '#' };
const TOPIC: Wildcards = { one: '*', rest: '**' };

/** Both sides of a mapping. */
export interface Sides {
  readonly foreign: AddressPath;
  readonly topic: AddressPath;
}

/**
 * Parses the two patterns of a mapping. `+` and `#` of the other system, or `*` and `**` of topics, capture text; `{1}`, `{2}`, …
 * of the other side stand for it, in the order of the wildcards. [BR-3]
 *
 * @throws Error with a sentence about what is wrong, and what to write instead
 */
export function parseSides(
  foreignText: string,
  topicText: string,
  direction: 'in' | 'out' | 'both',
): Sides {
  const wildForeign = parse(foreignText, FOREIGN, 'foreign');
  const wildTopic = parse(topicText, TOPIC, 'topic');
  if (wildForeign.wildcards.length > 0 && wildTopic.wildcards.length > 0) {
    throw new Error(
      'Both patterns have wildcards. Keep those of one side, and write {1}, {2}, … on the other.',
    );
  }
  const known = [...wildForeign.wildcards, ...wildTopic.wildcards];
  const foreign = complete(wildForeign, known, 'foreign');
  const topic = complete(wildTopic, known, 'topic');
  if (direction !== 'out') expectCaptured(foreign, topic, 'topic');
  if (direction !== 'in') expectCaptured(topic, foreign, 'foreign');
  return { foreign, topic };
}

/** Returns what the pattern captures in the text; `undefined` when it does not match. */
export function matchPath({ levels }: AddressPath, text: string): Captures | undefined {
  const parts = text.split('/');
  const last = levels.at(-1);
  const fits =
    last?.isRest === true ? parts.length >= levels.length : parts.length === levels.length;
  if (!fits) return undefined;
  const captures = new Map<number, string>();
  for (const [index, level] of levels.entries()) {
    const part = level.isRest ? parts.slice(index).join('/') : parts[index]!;
    if (level.capture === undefined) {
      if (part !== level.before) return undefined;
      continue;
    }
    const { before, after } = level;
    if (part.length <= before.length + after.length) return undefined;
    if (!part.startsWith(before) || !part.endsWith(after)) return undefined;
    captures.set(level.capture, part.slice(before.length, part.length - after.length));
  }
  return captures;
}

/** Returns the text that the pattern describes with these captures. */
export function fillPath({ levels }: AddressPath, captures: Captures): string {
  return levels
    .map(({ before, capture, after }) =>
      capture === undefined ? before : `${before}${captures.get(capture) ?? ''}${after}`,
    )
    .join('/');
}

/** Returns captures of a text that the pattern matches: `a`, `b`, …, and two levels for a rest. */
export function exampleOf({ levels }: AddressPath): Captures {
  const captures = new Map<number, string>();
  for (const { capture, isRest } of levels) {
    if (capture === undefined) continue;
    const letter = String.fromCharCode(96 + ((capture - 1) % 26) + 1);
    captures.set(capture, isRest ? `${letter}/${letter}` : letter);
  }
  return captures;
}

/** Whether the pattern stands for more than one text. */
export function isPattern({ levels }: AddressPath): boolean {
  return levels.some(({ capture }) => capture !== undefined);
}

/** Returns the pattern with `+` and `#`, as MQTT subscribes. */
export function toFilter({ levels }: AddressPath): string {
  return levels
    .map(({ before, capture, isRest }) => (capture === undefined ? before : isRest ? '#' : '+'))
    .join('/');
}

/** Returns the pattern as a glob of topics. */
export function toGlob({ levels }: AddressPath): string {
  return levels
    .map(({ before, capture, after, isRest }) =>
      capture === undefined ? before : `${before}${isRest ? '**' : '*'}${after}`,
    )
    .join('/');
}

interface Parsed {
  readonly text: string;
  readonly levels: readonly Level[];
  /** For each wildcard, in order, whether it captures all levels that follow. */
  readonly wildcards: readonly boolean[];
}

function parse(text: string, { one, rest }: Wildcards, side: string): Parsed {
  const wildcards: boolean[] = [];
  const parts = text.split('/');
  const levels = parts.map((part, index): Level => {
    const isLast = index === parts.length - 1;
    if (part === one || part === rest) {
      if (part === rest && !isLast) {
        throw new Error(`"${rest}" may only be the last level of \`${side}\`.`);
      }
      wildcards.push(part === rest);
      const capture = wildcards.length;
      return { before: '', capture, after: '', isRest: part === rest };
    }
    if ([one, rest, '?'].some((wildcard) => wildcard !== '' && part.includes(wildcard))) {
      throw new Error(
        `The level "${part}" of \`${side}\` mixes a wildcard with text. Use "${one}" for a whole level or "${rest}" for all that follow.`,
      );
    }
    return parsePlaceholder(part, side);
  });
  return { text, levels, wildcards };
}

function parsePlaceholder(part: string, side: string): Level {
  const [before = '', number, after = '', ...more] = part.split(/\{(\d{1,2})\}/);
  if (more.length > 0) {
    throw new Error(
      `The level "${part}" of \`${side}\` has two placeholders. Put a / between them.`,
    );
  }
  if (/[{}]/.test(before + after)) {
    throw new Error(`The level "${part}" of \`${side}\` has braces. Placeholders are {1}, {2}, ….`);
  }
  const capture = number === undefined ? undefined : Number(number);
  return { before, capture, after, isRest: false };
}

/** Placeholders learn what they stand for. */
function complete(
  { text, levels, wildcards }: Parsed,
  known: readonly boolean[],
  side: string,
): AddressPath {
  if (wildcards.length > 0) return { text, levels };
  const seen = new Set<number>();
  const completed = levels.map((level, index): Level => {
    const { capture } = level;
    if (capture === undefined) return level;
    const isRest = known[capture - 1];
    if (isRest === undefined) {
      throw new Error(
        `\`${side}\` has the placeholder {${capture}}, but the other pattern has ${known.length === 0 ? 'no wildcard' : `only ${known.length}`}.`,
      );
    }
    if (seen.has(capture)) throw new Error(`\`${side}\` has the placeholder {${capture}} twice.`);
    seen.add(capture);
    if (isRest && (index < levels.length - 1 || level.before + level.after !== '')) {
      throw new Error(
        `{${capture}} stands for several levels, so it has to be the whole last level of \`${side}\`.`,
      );
    }
    return { ...level, isRest };
  });
  return { text, levels: completed };
}

/** @param side of `to` */
function expectCaptured(from: AddressPath, to: AddressPath, side: string): void {
  const captured = new Set(from.levels.map(({ capture }) => capture));
  const missing = to.levels.find(({ capture }) => !captured.has(capture));
  if (missing?.capture === undefined) return;
  throw new Error(
    `\`${side}\` needs {${missing.capture}}, which \`${side === 'topic' ? 'foreign' : 'topic'}\` does not capture in this direction.`,
  );
}
