import { parseDataFormat, type JsonObject } from '@ubii/proto';

import { around, FOUR_PARAMETERS } from './callback-texts.ts';

/**
 * A module as JSON whose `onProcessingStringified` has the parameters of today. Earlier masters called it with
 * `(deltaTime, inputs, outputs, state)`, with bare values in both, and published what it wrote into `outputs`. [SE-29]
 */
export function withThreeParameters(module: JsonObject): JsonObject {
  const { onProcessingStringified: text } = module;
  if (typeof text !== 'string') return module;
  const parameters = parametersOf(text)?.split(',') ?? [];
  if (parameters.length < 4) return module;
  const members = JSON.stringify(membersOf(module['outputs']));
  const onProcessingStringified = around(text, `${FOUR_PARAMETERS}(given, ${members})`);
  return { ...module, onProcessingStringified };
}

/** Record members of outputs, by name; outputs of unknown data formats are left out. */
export function membersOf(outputs: unknown): Readonly<Record<string, string>> {
  const members: Record<string, string> = {};
  for (const output of Array.isArray(outputs) ? (outputs as unknown[]) : []) {
    const { internalName, messageFormat } = (output ?? {}) as Record<string, unknown>;
    if (typeof internalName !== 'string' || typeof messageFormat !== 'string') continue;
    const format = parseDataFormat(messageFormat);
    if (format !== undefined) members[internalName] = format;
  }
  return members;
}

/** What stands between the parentheses of a function expression or an arrow function that a text begins with. */
function parametersOf(text: string): string | undefined {
  let at = 0;
  // Each pattern is tried at one place only: a single one for all of them takes the square of the time for long gaps.
  const take = (pattern: RegExp): string => {
    pattern.lastIndex = at;
    const [found = ''] = pattern.exec(text) ?? [];
    at += found.length;
    return found;
  };
  take(/\s*/y);
  if (take(/async\b/y) !== '') take(/\s*/y);
  if (take(/function\b/y) !== '') {
    for (const part of [/\s*/y, /[\w$]*/y, /\s*/y]) take(part);
  }
  if (text[at] !== '(') return undefined;
  const end = text.indexOf(')', at);
  const parameters = text.slice(at + 1, end);
  return end < 0 || parameters.includes('(') ? undefined : parameters;
}
