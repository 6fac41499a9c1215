import type { ModuleFault } from '../ports/module-fault.ts';
import type { SandboxInput } from '../ports/sandbox.ts';
import { undeclaredName } from './nearest-name.ts';

/** An input as the author reads it. */
interface ReadInput {
  readonly name: string;
  /** `inputs.pointer`, or the name the author gave it. */
  readonly written: string;
}

const SECOND_PARAMETER =
  /^\s*(?:async\b\s*)?(?:function\b\s*)?[\w$]*\s*\(\s*[\w$]+\s*,\s*(?:([\w$]+)|\{([^{}]*)\})/;

/**
 * Says which input was read before it had a value, when an error of onProcessing comes from that. The
 * words of the engine stay behind it.
 *
 * @param source of onProcessing
 * @param declared names of the inputs
 * @param given the inputs of the run
 */
export function explainThrow(
  fault: ModuleFault,
  source: string,
  declared: readonly string[],
  given: readonly SandboxInput[],
): ModuleFault {
  const { kind, line, message } = fault;
  if (kind !== 'threw' || line === undefined || !/TypeError.*undefined/.test(message)) return fault;
  const text = source.split('\n')[line - 1] ?? '';
  for (const read of readInputs(source, text)) {
    const cause = causeOf(read, declared, given);
    if (cause !== undefined) return { ...fault, message: `${cause} (${message})` };
  }
  return fault;
}

function causeOf(
  { name, written }: ReadInput,
  declared: readonly string[],
  given: readonly SandboxInput[],
): string | undefined {
  const input = given.find((one) => one.name === name);
  const advice = `Return before you read it: if (!${written}) return;`;
  if (input === undefined) {
    return declared.includes(name)
      ? `Input "${name}" is not connected. ${advice}`
      : undeclaredName('Input', name, declared);
  }
  const isEmpty = 'record' in input && input.record === undefined;
  return isEmpty ? `Input "${name}" has no value yet. ${advice}` : undefined;
}

/** A name and its member: `inputs.pointer`. */
const MEMBER = /(?<![\w$.])([\w$]+)\s*\.\s*([\w$]+)/g;
/** A part of `{ anchor, pointer: here }`. */
const BOUND = /^\s*([\w$]+)\s*(?::\s*([\w$]+)\s*)?$/;

/** The inputs whose members a line reads, by the names of the second parameter. */
function readInputs(source: string, line: string): ReadInput[] {
  const [, parameter, pattern = ''] = SECOND_PARAMETER.exec(source) ?? [];
  const members = [...line.matchAll(MEMBER)];
  if (parameter !== undefined) {
    return members
      .filter(([, owner]) => owner === parameter)
      .map(([written, , name = '']) => ({ name, written }));
  }
  const owners = new Set(members.map(([, owner]) => owner));
  return pattern.split(',').flatMap((part) => {
    const [, name, alias = name] = BOUND.exec(part) ?? [];
    if (name === undefined || alias === undefined || !owners.has(alias)) return [];
    return [{ name, written: alias }];
  });
}
