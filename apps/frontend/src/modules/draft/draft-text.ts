import { textOfDefault } from './io-default.ts';
import type { IoDraft, ModeDraft, ModuleDraft } from './module-draft.ts';

function ioWords(io: IoDraft): string {
  const { name, format, isList, description, choices = [] } = io;
  const words = `${name}: ${isList ? 'list of ' : ''}${format || 'any format'}`;
  const oneOf = choices.length > 0 ? `one of ${choices.join(', ')}` : undefined;
  const standard = io.defaultJson === undefined ? undefined : `default ${textOfDefault(io)}`;
  return [words, standard, oneOf, description].filter(Boolean).join('; ');
}

function modeText({ kind, hertz, minDelayMs, allInputsNeedUpdate }: ModeDraft): string {
  switch (kind) {
    case 'frequency':
      return `at ${hertz} Hz`;
    case 'trigger': {
      const when = allInputsNeedUpdate ? 'when all inputs arrived' : 'when an input arrives';
      return minDelayMs > 0 ? `${when}, not sooner than ${minDelayMs} ms` : when;
    }
    case 'lockstep':
      return 'in lockstep';
    case 'free':
      return 'as often as possible';
  }
}

/** Formats a module as one text for line-by-line comparison: declarations, then code. */
export function draftText(draft: ModuleDraft): string {
  const lines = [
    `Name: ${draft.name}`,
    `Description: ${draft.description}`,
    ...draft.inputs.map((io) => `Input ${ioWords(io)}`),
    ...draft.outputs.map((io) => `Output ${ioWords(io)}`),
    `Runs: ${modeText(draft.mode)}`,
    `Tags: ${draft.tags.join(', ')}`,
    `Authors: ${draft.authors.join(', ')}`,
    `Libraries: ${draft.libraries.join(', ')}`,
    `Asset sets: ${draft.assets.join(', ')}`,
    `Optional asset sets: ${draft.optionalAssets.join(', ')}`,
    `Version: ${draft.version}`,
  ];
  return `${lines.map((line) => `// ${line}`.trimEnd()).join('\n')}\n\n${draft.code}`;
}
