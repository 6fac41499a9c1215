import { parseDataFormat } from '@ubii/proto';
import type { IoDraft, ModuleDraft } from '../../draft/module-draft.ts';
import { offsetOf, splitText, type TextPlace } from '../../text/module-text.ts';
import { bodyOffset } from '../../text/return-place.ts';
import type { CodeMark } from './code-mark.ts';

/** Change that a message about the code names. */
export type CodeFix = { readonly title: string } & (
  | { readonly kind: 'rename'; readonly from: string; readonly to: string }
  | { readonly kind: 'declare'; readonly side: 'inputs' | 'outputs'; readonly name: string }
  | { readonly kind: 'guard'; readonly statement: string }
);

const UNDECLARED = /^(Input|Output) "([^"]+)" is not declared\./;
const WRONG = /(?:Property|name|but) '([\w$]+)'|^(?:Input|Output) "([\w$]+)"/;
const MEANT = /Did you mean (?:to write )?["']([\w$]+)["']\?/;
const GUARD = /^([\w$.]+) has no value until .+: (if \(.+\) return;)$/;
const WORD = /[\p{ID_Start}$_][\p{ID_Continue}$]*/uy;
/** Member that the code reads of an input, or writes into an output. */
const MEMBER = /\s*(?:\??\.|:\s*\{)\s*([\w$]+)/y;

/** Returns the fixes for a problem, as worded by `typeWords` or a run; the likeliest first. */
export function codeFixes(
  mark: TextPlace & Pick<CodeMark, 'message'>,
  { code }: Pick<ModuleDraft, 'code'>,
): readonly CodeFix[] {
  const { message } = mark;
  const fixes: CodeFix[] = [];
  const [, before, after] = WRONG.exec(message) ?? [];
  const from = before ?? after;
  const to = MEANT.exec(message)?.[1];
  if (from !== undefined && to !== undefined && wordAt(code, mark) === from) {
    fixes.push({ kind: 'rename', title: `Change to ${to}`, from, to });
  }
  const [, io, name] = UNDECLARED.exec(message) ?? [];
  if (name !== undefined) {
    fixes.push(
      io === 'Input'
        ? { kind: 'declare', title: `Add an input ${name}`, side: 'inputs', name }
        : { kind: 'declare', title: `Add an output ${name}`, side: 'outputs', name },
    );
  }
  const [, input, statement] = GUARD.exec(message) ?? [];
  if (statement !== undefined) {
    fixes.push({ kind: 'guard', title: `Return while ${input} has no value`, statement });
  }
  return fixes;
}

/** Returns the change of the module that a fix at this position makes. */
export function applyFix(draft: ModuleDraft, place: TextPlace, fix: CodeFix): Partial<ModuleDraft> {
  const { code } = draft;
  switch (fix.kind) {
    case 'rename': {
      const at = offsetOf(code, place);
      return { code: code.slice(0, at) + fix.to + code.slice(at + fix.from.length) };
    }
    case 'declare':
      return { [fix.side]: [...draft[fix.side], declared(fix.name, code, place)] };
    case 'guard': {
      const at = bodyAt(code, place);
      return at === undefined
        ? {}
        : { code: `${code.slice(0, at)}\n  ${fix.statement}${code.slice(at)}` };
    }
  }
}

function wordAt(code: string, place: TextPlace): string | undefined {
  WORD.lastIndex = offsetOf(code, place);
  return WORD.exec(code)?.[0];
}

/** Returns an input or output with the data format that the code uses at its name. */
function declared(name: string, code: string, place: TextPlace): IoDraft {
  MEMBER.lastIndex = offsetOf(code, place) + name.length;
  const member = (wordAt(code, place) === name && MEMBER.exec(code)?.[1]) || '';
  return { name, format: parseDataFormat(member) ?? 'double', isList: member === 'elements' };
}

/** Returns the start of the body of the callback around a position. */
function bodyAt(code: string, { line }: TextPlace): number | undefined {
  const section = splitText(code).sections.findLast(({ at }) => at.line <= line);
  const body = section && bodyOffset(section.source);
  return body === undefined ? undefined : offsetOf(code, section!.at) + body;
}
