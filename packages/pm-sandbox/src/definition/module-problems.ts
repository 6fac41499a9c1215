import { ProcessingModuleLanguage, type ModuleIO, type ProcessingModule } from '@ubii/proto';
import { MAX_SOURCE_BYTES } from '../sandbox-limits.ts';

/** Something wrong with a module. */
export interface ModuleProblem {
  /** Where, as in `inputs[1].internalName`; empty for the module as a whole. */
  readonly path: string;
  /** One sentence. */
  readonly message: string;
}

const CALLBACKS = [
  'onCreatedStringified',
  'onProcessingStringified',
  'onHaltedStringified',
  'onDestroyedStringified',
] as const;

/**
 * All that can be said against a module without running it. Formats that are not known are no
 * problem. [PM-3] [PM-57]
 *
 * @returns empty when it is fine
 */
export function moduleProblems(module: ProcessingModule): ModuleProblem[] {
  const problems: ModuleProblem[] = [];
  if (module.name.trim() === '') problems.push({ path: 'name', message: 'A module needs a name.' });
  checkNames(module.inputs, 'inputs', 'input', problems);
  checkNames(module.outputs, 'outputs', 'output', problems);
  checkSource(module, problems);
  return problems;
}

function checkNames(
  ios: readonly ModuleIO[],
  path: string,
  kind: string,
  problems: ModuleProblem[],
): void {
  const seen = new Map<string, number>();
  ios.forEach(({ internalName }, i) => {
    const at = `${path}[${i}].internalName`;
    if (internalName === '') {
      problems.push({ path: at, message: `The ${kind} has no internal name.` });
      return;
    }
    const first = seen.get(internalName);
    if (first === undefined) seen.set(internalName, i);
    else {
      const message = `Two ${kind}s are named "${internalName}". The first is ${path}[${first}].`;
      problems.push({ path: at, message });
    }
  });
}

function checkSource(module: ProcessingModule, problems: ModuleProblem[]): void {
  const given = CALLBACKS.filter((member) => module[member].trim() !== '');
  if (given.length === 0) return;
  // Clients that mean no language send the number of C++.
  const isJavaScript =
    module.language === ProcessingModuleLanguage.JS ||
    module.language === ProcessingModuleLanguage.CPP;
  if (isJavaScript && !given.includes('onProcessingStringified')) {
    const message = `A module with ${given[0]} also needs onProcessingStringified.`;
    problems.push({ path: 'onProcessingStringified', message });
  }
  const sizeBytes = given.reduce((sum, member) => sum + utf8Length(module[member]), 0);
  if (sizeBytes > MAX_SOURCE_BYTES) {
    const message = `The source of the module has ${sizeBytes} bytes; the limit is ${MAX_SOURCE_BYTES} bytes.`;
    problems.push({ path: '', message });
  }
}

/** Bytes of a text in UTF-8, without making them. */
function utf8Length(text: string): number {
  let bytes = text.length;
  for (let i = 0; i < text.length; i++) {
    const unit = text.charCodeAt(i);
    if (unit < 0x80) continue;
    // A surrogate is half of a character of four bytes.
    bytes += unit < 0x800 || (unit >= 0xd800 && unit <= 0xdfff) ? 1 : 2;
  }
  return bytes;
}
