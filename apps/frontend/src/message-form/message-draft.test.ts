import { findJsonProblems } from '@ubii/proto';
import { expect, it } from 'vitest';
import { createMessageDraft } from './message-draft.ts';

const draft = () =>
  createMessageDraft({ topic: '/a', vector2: { x: 1, y: 2 } }, (json) =>
    findJsonProblems('ubii.topicData.TopicDataRecord', json),
  );

it('form and text are the same message', () => {
  const { text, json, setJson, setText, problems } = draft();
  setJson({ topic: '/a', vector2: { x: 3, y: 2 } });
  expect(text.value).toContain('"x": 3');
  setText('{"topic":"/b","double":1}');
  expect(json.value).toEqual({ topic: '/b', double: 1 });
  expect(problems.value).toEqual([]);
});

it('what is wrong stands at its place', () => {
  const { setJson, problems, problemByPath } = draft();
  setJson({ topic: '/a', vector2: { x: 'left', y: 2 } });
  expect(problems.value).toEqual([
    { path: 'vector2.x', line: 4, column: 5, sentence: 'must be a number, got "left"' },
  ]);
  expect(problemByPath.value.get('vector2.x')).toContain('"left"');
});

it('a text that is no JSON leaves the form as it was', () => {
  const { setText, json, isJson, problems } = draft();
  setText('{"topic": ');
  expect(isJson.value).toBe(false);
  expect(json.value['topic']).toBe('/a');
  expect(problems.value[0]).toMatchObject({ path: '', line: 1, column: 11 });
  setText('[1]');
  expect(problems.value[0]!.sentence).toContain('an object');
});
