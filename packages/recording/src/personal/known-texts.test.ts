import { expect, it } from 'vitest';
import { isTelling, KnownTexts } from './known-texts.ts';

const ID = '1b9d6bcd-bbfd-4b2d-9b5d-ab8dfbbd4bed';

function known(): KnownTexts {
  const texts = new KnownTexts();
  texts.add('Ada', 'client-1');
  texts.add('Ada Lovelace', 'client-2');
  texts.add(ID, 'id-3');
  texts.add('Bo', 'client-4');
  texts.add('@grace', 'client-5');
  texts.add('🎈', 'client-6');
  texts.add('İpek', 'client-7');
  return texts;
}

it.each([
  ['Ada won', 'client-1 won'],
  ['ADA and ada', 'client-1 and client-1'],
  ['Ada Lovelace won, not Ada', 'client-2 won, not client-1'],
  ['Adam and Canada stay', 'Adam and Canada stay'],
  ['{"player":"Ada","ids":["' + ID + '"]}', '{"player":"client-1","ids":["id-3"]}'],
  ['ada_score', 'client-1_score'],
  ['by @grace.', 'by client-5.'],
  ['🎈', 'client-6'],
  ['İpek and Ada', 'client-7 and client-1'],
  ['Bo', 'client-4'],
  ['Bo in a sentence is too short to be found', 'Bo in a sentence is too short to be found'],
  ['', ''],
])('%j becomes %j', (text, wanted) => {
  expect(known().replaceIn(text)).toBe(wanted);
});

it.each([
  [`/${ID}/position`, '/id-3/position'],
  ['/lab/Ada/position', '/lab/client-1/position'],
  ['/lab/bo/🎈', '/lab/client-4/client-6'],
  [`/ghost-${ID.toUpperCase()}`, '/ghost-id-3'],
  ['/adapter', '/adapter'],
])('topic %s becomes %s', (topic, wanted) => {
  expect(known().replaceInTopic(topic)).toBe(wanted);
});

it.each([
  ['a name in Chinese', '王小明', '我叫王小明。', '我叫x。'],
  ['a name in Korean', '김철수', '김철수는 학생이다', 'x는 학생이다'],
  ['a name with ß', 'Straße', 'in der STRASSE', 'in der x'],
  ['an apostrophe', "O'Brien", 'by O’Brien', 'by x'],
  ['a name after a folder', 'Nina', String.raw`C:\\home\nina\a`, String.raw`C:\\home\x\a`],
  ['a number', '491701234567', '{"phone":491701234567,"n":1e5}', '{"phone":"x","n":1e5}'],
  ['a value that is escaped itself', 'Jos%C3%A9', 'by José', 'by x'],
  ['the longest of several', 'Ada Lovelace', 'ada lovelace-king', 'x-king'],
])('[PD-17] finds %s', (_, known, text, wanted) => {
  const texts = new KnownTexts();
  texts.add('Ada', 'y');
  texts.add(known, 'x');
  expect(texts.replaceIn(text)).toBe(wanted);
});

it('[PD-17] leaves JSON as it is around what it replaces', () => {
  const json = '{ "id": 12345678901234567890,\n  "who": "Jos\\u00e9", "is": [true, 1.50] }';
  const texts = new KnownTexts();
  texts.add('José', 'x');
  expect(texts.replaceIn(json)).toBe(json.replace('Jos\\u00e9', 'x'));
  texts.add('nothing of it', 'y');
  expect(texts.replaceIn('{"a":"b\\u0020c"}')).toBe('{"a":"b\\u0020c"}');
});

it('[PD-17] replaces the whole of a text that has the first words of a long one', () => {
  const long = Array.from({ length: 40 }, (_, place) => `word${place}`).join(' ');
  const texts = new KnownTexts();
  texts.add(long, 'x');
  expect(texts.replaceIn(`He said: ${long}.`)).toBe('x');
  expect(texts.replaceIn('word0 word1')).toBe('word0 word1');
});

it('[PD-18] searches texts only for what tells enough', () => {
  expect(['ada', '王明', '80333', '1999 12 31'].filter(isTelling)).toHaveLength(4);
  expect(['al', '王', '2024', '7 5', '!?'].filter(isTelling)).toEqual([]);
});

it('finds texts in long ones, whatever they are made of', () => {
  const texts = new KnownTexts();
  for (let count = 4; count < 24; count++) texts.add(`${'a '.repeat(count)}b`, 'x');
  expect(texts.replaceIn('a '.repeat(50_000)).length).toBe(100_000);
  const quoted = JSON.stringify(['\\"'.repeat(200_000)]);
  expect(texts.replaceIn(quoted)).toBe(quoted);
});
