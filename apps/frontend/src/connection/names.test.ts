import { describe, expect, it } from 'vitest';
import { describeAgent } from './agent-description.ts';
import { friendlyName } from './friendly-name.ts';

it('a generated name is two words, whatever the dice say', () => {
  expect(friendlyName(() => 0)).toMatch(/^[A-Z][a-z]+ [A-Z][a-z]+$/);
  expect(friendlyName(() => 0.999999)).toMatch(/^[A-Z][a-z]+ [A-Z][a-z]+$/);
});

describe('describeAgent', () => {
  it.each([
    [
      'Mozilla/5.0 (iPhone; CPU iPhone OS 18_0 like Mac OS X) AppleWebKit/605.1.15 (KHTML, like Gecko) Version/18.0 Mobile/15E148 Safari/604.1',
      'iPhone, Safari',
    ],
    [
      'Mozilla/5.0 (Linux; Android 15; Pixel 9) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/132.0.0.0 Mobile Safari/537.36',
      'Android, Chrome',
    ],
    [
      'Mozilla/5.0 (Windows NT 10.0; Win64; x64) AppleWebKit/537.36 (KHTML, like Gecko) Chrome/132.0.0.0 Safari/537.36 Edg/132.0.0.0',
      'Windows, Edge',
    ],
    ['Mozilla/5.0 (X11; Linux x86_64; rv:134.0) Gecko/20100101 Firefox/134.0', 'Linux, Firefox'],
    ['', 'Browser'],
  ])('%s', (agent, expected) => {
    expect(describeAgent(agent)).toBe(expected);
  });
});
