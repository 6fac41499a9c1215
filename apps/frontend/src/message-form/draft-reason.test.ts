import { findJsonProblems } from '@ubii/proto';
import { expect, it } from 'vitest';
import { draftReason } from './draft-reason.ts';
import { createMessageDraft } from './message-draft.ts';

const draft = () =>
  createMessageDraft({ topic: '/a', double: 1 }, (json) =>
    findJsonProblems('ubii.topicData.TopicDataRecord', json),
  );

it('a valid draft has no reason', () => {
  expect(draftReason(draft())).toBeUndefined();
});

it('names the line of a syntax error, although the last valid message is kept', () => {
  const broken = draft();
  broken.setText(`${broken.text.value}}`);
  expect(broken.json.value).toEqual({ topic: '/a', double: 1 });
  expect(draftReason(broken)).toBe(
    'The JSON is not valid. Line 4: Expected nothing more, found "}".',
  );
});

it('names the member that is wrong', () => {
  const wrong = draft();
  wrong.setJson({ topic: '/a', double: 'a' });
  expect(draftReason(wrong)).toBe('double must be a number, got "a".');
  wrong.setJson({ topic: '/a', doubl: 1 });
  expect(draftReason(wrong)).toBe('doubl is not known here. Did you mean double?');
});
