import { expect, it } from 'vitest';
import { KnownTexts } from './known-texts.ts';

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
