import type { ModulePhase } from '@ubii/pm-sandbox';
import type { ProcessingModule } from '@ubii/proto';
import { maskSource } from './mask-source.ts';

/** A callback of a module, by its name in the text. */
export type Callback = Exclude<ModulePhase, ''>;

/** In the order of an instance's life cycle. */
export const CALLBACKS: readonly Callback[] = [
  'onCreated',
  'onProcessing',
  'onHalted',
  'onDestroyed',
];

/** Position in the text, line and column from 1. */
export interface TextPlace {
  readonly line: number;
  readonly column: number;
}

/** A callback in the text. */
export interface TextSection {
  readonly callback: Callback;
  /** Function expression. [PM-2] */
  readonly source: string;
  /** Start of the source. */
  readonly at: TextPlace;
}

/** Problem in a text, with its position. */
export interface TextProblem extends TextPlace {
  readonly message: string;
  readonly severity: 'error' | 'warning';
}

/** Result of parsing a text. */
export interface ModuleText {
  readonly sections: readonly TextSection[];
  readonly problems: readonly TextProblem[];
}

const SECTION = /(?<=^|[\n;])[ \t]*(onCreated|onProcessing|onHalted|onDestroyed)\s*=(?![=>])/g;

type Sources = Pick<
  ProcessingModule,
  | 'onCreatedStringified'
  | 'onProcessingStringified'
  | 'onHaltedStringified'
  | 'onDestroyedStringified'
>;

/** Joins all callbacks of a module to one text: the source of each, after its name. */
export function composeText(module: Sources): string {
  return CALLBACKS.map((callback) => [callback, module[`${callback}Stringified`].trim()] as const)
    .filter(([, source]) => source !== '')
    .map(([callback, source]) => `${callback} = ${source};\n`)
    .join('\n');
}

export function placeOf(text: string, offset: number): TextPlace {
  const before = text.slice(0, offset);
  const lineStart = before.lastIndexOf('\n') + 1;
  return { line: before.split('\n').length, column: offset - lineStart + 1 };
}

/** Returns the offset of a position; beyond the end of the text, its length. */
export function offsetOf(text: string, { line, column }: TextPlace): number {
  let start = 0;
  for (let skipped = 1; skipped < line; skipped += 1) {
    const end = text.indexOf('\n', start);
    if (end < 0) return text.length;
    start = end + 1;
  }
  return start + column - 1;
}

/** Extracts the callbacks of a text, and reports everything that would be lost. */
export function splitText(text: string): ModuleText {
  const mask = maskSource(text);
  const starts = [...mask.matchAll(SECTION)];
  const sections: TextSection[] = [];
  const problems: TextProblem[] = [];
  const report = (offset: number, severity: TextProblem['severity'], message: string): void => {
    problems.push({ ...placeOf(text, offset), severity, message });
  };
  /** Only callbacks are stored. [PM-2] */
  const lookOutside = (from: number, to: number): void => {
    const code = mask.slice(from, to).search(/[^\s;]/);
    if (code >= 0) {
      report(
        from + code,
        'error',
        'Code outside the callbacks is not saved. Move it into a callback, such as onProcessing.',
      );
      return;
    }
    const comment = text.slice(from, to).search(/[^\s;]/);
    if (comment >= 0) {
      report(
        from + comment,
        'warning',
        'Code outside the callbacks is not saved. Move it into a callback.',
      );
    }
  };
  let read = 0;
  starts.forEach((start, index) => {
    lookOutside(read, start.index);
    const callback = start[1] as Callback;
    const from = start.index + start[0].length;
    const limit = starts[index + 1]?.index ?? text.length;
    const semicolon = mask.indexOf(';', from);
    const end = semicolon >= 0 && semicolon < limit ? semicolon : limit;
    const source = text.slice(from, end).trim();
    const at = placeOf(text, from + text.slice(from).search(/\S|$/));
    if (sections.some((one) => one.callback === callback)) {
      report(start.index, 'error', `${callback} is defined twice.`);
    } else if (source === '') {
      report(start.index, 'error', `${callback} needs a function after the equals sign.`);
    } else sections.push({ callback, source, at });
    read = end;
  });
  lookOutside(read, text.length);
  if (!sections.some(({ callback }) => callback === 'onProcessing')) {
    problems.push({
      line: 1,
      column: 1,
      severity: 'error',
      message: 'A module needs onProcessing = (deltaTimeMs, inputs, state) => { … };',
    });
  }
  return { sections, problems };
}

/** Returns the sources of the callbacks, in the form of a module; missing ones are empty. */
export function sourcesOf({ sections }: ModuleText): Sources {
  const of = (callback: Callback): string =>
    sections.find((section) => section.callback === callback)?.source ?? '';
  return {
    onCreatedStringified: of('onCreated'),
    onProcessingStringified: of('onProcessing'),
    onHaltedStringified: of('onHalted'),
    onDestroyedStringified: of('onDestroyed'),
  };
}

/** Converts a position in the source of a callback to a position in the text; `undefined` when it is unknown. */
export function placeInText(
  { sections }: ModuleText,
  fault: {
    readonly phase: string;
    readonly line?: number | undefined;
    readonly column?: number | undefined;
  },
): TextPlace | undefined {
  const section = sections.find(({ callback }) => callback === fault.phase);
  if (section === undefined) return undefined;
  const { line = 0, column = 0 } = fault;
  if (line <= 1) {
    return { line: section.at.line, column: section.at.column + Math.max(0, column - 1) };
  }
  return { line: section.at.line + line - 1, column: Math.max(1, column) };
}

/** Returns the position in the text of an address such as `onProcessing:7:12`. */
export function addressInText(text: ModuleText, address: string): TextPlace | undefined {
  const [phase = '', line, column] = address.split(':');
  return placeInText(text, { phase, line: Number(line) || 0, column: Number(column) || 0 });
}
