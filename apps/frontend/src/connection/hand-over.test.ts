import { describe, expect, it } from 'vitest';
import { handOverUrl, takeHandOver } from './hand-over.ts';

const IDENTITY = JSON.stringify({ clientId: 'ada', resumeToken: 't', credential: 'c&#%' });

function storages(tab: object = {}, browser: object = {}) {
  const of = (entries: object) => {
    const map = new Map<string, string>(Object.entries(entries));
    return {
      map,
      getItem: (key: string) => map.get(key) ?? null,
      setItem: (key: string, value: string) => void map.set(key, value),
    };
  };
  return { tab: of(tab), browser: of(browser) };
}

/** Opens a URL in a tab with these storages. */
function open(url: string, into = storages()) {
  const { hash, pathname, search } = new URL(url);
  const shown: unknown[] = [];
  const history = { state: null, replaceState: (...given: unknown[]) => void shown.push(given[2]) };
  takeHandOver({ hash, pathname, search }, history, into);
  return {
    shown,
    identity: into.tab.map.get('ubii.identity'),
    name: into.browser.map.get('ubii.name'),
  };
}

const from = storages({ 'ubii.identity': IDENTITY }, { 'ubii.name': 'Mara' });
const url = handOverUrl('https://10.0.0.6:8080', '/devices/smart-device?x=1', from);

describe('a page that moves its address to another master [CU-97]', () => {
  it('is the same client there, with its name, and shows no secret in its address', () => {
    expect(url).toMatch(/^https:\/\/10\.0\.0\.6:8080\/devices\/smart-device\?x=1#moved=/);
    expect(open(url)).toEqual({
      shown: ['/devices/smart-device?x=1'],
      identity: IDENTITY,
      name: 'Mara',
    });
  });

  it('changes neither the identity of a known client nor the name of a browser', () => {
    const known = storages({ 'ubii.identity': 'ben' }, { 'ubii.name': 'Ben' });
    expect(open(url, known)).toEqual({
      shown: ['/devices/smart-device?x=1'],
      identity: 'ben',
      name: 'Ben',
    });
  });

  it.each([
    '#moved=',
    '#moved=%7B',
    '#moved=null',
    '#moved=%7B%22identity%22%3A1%7D',
    `#moved=${'x'.repeat(5000)}`,
  ])('takes nothing from %j, and removes it', (hash) => {
    const opened = open(`http://a/topics${hash}`);
    expect(opened).toEqual({ shown: ['/topics'], identity: undefined, name: undefined });
  });

  it('leaves other fragments alone, and goes without an identity when it has none', () => {
    expect(open('http://a/join#token').shown).toEqual([]);
    expect(handOverUrl('http://b:1', '/topics', storages())).toBe('http://b:1/topics');
    expect(handOverUrl('http://b:1', '/topics', undefined)).toBe('http://b:1/topics');
  });
});
