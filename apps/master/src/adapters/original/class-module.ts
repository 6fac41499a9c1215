import type { ModuleFault, SandboxFactory } from '@ubii/pm-sandbox';
import { decodeRecord, LEGACY_CONSTANTS, type JsonObject } from '@ubii/proto';

import { around, CLASS_MODULE, FOUR_PARAMETERS } from './callback-texts.ts';
import { membersOf } from './four-parameters.ts';

/** Limits of reading the description of a module. */
const READ_LIMITS = {
  callTimeoutMs: 500,
  memoryBytes: 64 * 1024 * 1024,
  outputBytes: 1024 * 1024,
};
/** Longest text: it is repeated in each callback, which together have `MAX_SOURCE_BYTES`. */
export const MAX_SCRIPT_BYTES = 200 * 1024;
const OWNER = 'original installation';

/**
 * The module of a CommonJS text that exports a class, as JSON. The text is run in a sandbox to read its description,
 * and comes with each callback as it is. [SE-29]
 *
 * @throws Error with one sentence
 */
export async function classModule(text: string, sandboxes: SandboxFactory): Promise<JsonObject> {
  const { callbacks, ...described } = await describe(text, sandboxes);
  if (typeof described['name'] !== 'string' || described['name'] === '') {
    throw new Error('Its class gives the module no name.');
  }
  if (!Array.isArray(callbacks) || !callbacks.includes('onProcessing')) {
    throw new Error('Its class has no method onProcessing.');
  }
  const members = membersOf(described['outputs']);
  const sources = (callbacks as string[]).map((phase) => [
    `${phase}Stringified`,
    callbackText(phase, text, members),
  ]);
  return { ...described, language: 'JS', ...Object.fromEntries(sources) } as JsonObject;
}

async function describe(
  text: string,
  sandboxes: SandboxFactory,
): Promise<Readonly<Record<string, unknown>>> {
  const sandbox = sandboxes.open(
    {
      instanceId: OWNER,
      moduleName: OWNER,
      source: { onProcessing: callbackText('describe', text, {}) },
      isTrusted: false,
      libraries: [],
      assets: [],
      inputs: [],
      outputs: [{ name: 'description', format: 'string' }],
      limits: READ_LIMITS,
      owner: OWNER,
    },
    { onLog: () => undefined, onKilled: () => undefined },
  );
  try {
    await sandbox.create();
    const { outputs, faults } = await sandbox.run({ deltaTimeMs: 0, inputs: [] });
    const [output] = outputs;
    if (output === undefined || !('value' in output)) {
      throw new Error(faults[0]?.message ?? 'Its description cannot be read.');
    }
    const { value } = decodeRecord(output.value.bytes);
    return JSON.parse(String(value)) as Readonly<Record<string, unknown>>;
  } catch (thrown) {
    throw new Error(sentenceOf(thrown as Error | ModuleFault, text), { cause: thrown });
  } finally {
    sandbox.terminate();
  }
}

function callbackText(
  phase: string,
  text: string,
  members: Readonly<Record<string, string>>,
): string {
  const constants = text.includes('ubii-msg-formats') ? JSON.stringify(LEGACY_CONSTANTS) : 'null';
  const facts = [JSON.stringify(phase), JSON.stringify(members), constants, FOUR_PARAMETERS];
  const define = `function (module, exports, require) {${text}\n}`;
  return around(define, `${CLASS_MODULE}(${facts.join(', ')}, given)`);
}

/** Faults name their line, unless it is one of ours, which follow those of the text. */
function sentenceOf(thrown: Error | ModuleFault, text: string): string {
  const { message, line = Infinity } = thrown as ModuleFault;
  return line <= text.split('\n').length ? `${message} (line ${line})` : message;
}
