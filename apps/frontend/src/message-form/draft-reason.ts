import { asSentence } from './form-problems.ts';
import type { MessageDraft } from './message-draft.ts';

/** Returns why a draft cannot be sent, one sentence for its button; undefined when it can. */
export function draftReason({ problems, isJson }: MessageDraft): string | undefined {
  const [problem] = problems.value;
  if (problem === undefined) return undefined;
  const { path, line, sentence } = problem;
  if (!isJson.value) return `The JSON is not valid. Line ${line}: ${sentence}`;
  return asSentence(path === '' ? sentence : `${path} ${sentence}`);
}
