import { parseDataFormat, type JsonObject } from '@ubii/proto';

import { around, FOUR_PARAMETERS } from './callback-texts.ts';

/** The parameters of a function expression or an arrow function at the start of a text. */
const PARAMETERS = /^\s*(?:async\b\s*)?(?:function\b\s*[\w$]*\s*)?\(([^()]*)\)/;

/**
 * A module as JSON whose `onProcessingStringified` has the parameters of today. Earlier masters called it with
 * `(deltaTime, inputs, outputs, state)`, with bare values in both, and published what it wrote into `outputs`. [SE-29]
 */
export function withThreeParameters(module: JsonObject): JsonObject {
  const { onProcessingStringified: text } = module;
  if (typeof text !== 'string') return module;
  const parameters = PARAMETERS.exec(text)?.[1]?.split(',') ?? [];
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
