import { describe, expect, it } from 'vitest';
import { lazyPatterns } from '../pattern-source.ts';
import { patternCompilerSuite } from '../testing/index.ts';
import { Re2Patterns } from './re2-patterns.ts';

patternCompilerSuite('Re2Patterns', () => new Re2Patterns());
patternCompilerSuite('lazyPatterns()', () => lazyPatterns().load());

describe('Re2Patterns', () => {
  it.each(['[(?=]', '\\(?=a', '[\\](?!]', '\\\\1', '(?:a)=!'])(
    'takes %j, which only looks like what is not supported',
    (source) => {
      expect(() => new Re2Patterns().compile(source)).not.toThrow();
    },
  );

  it('takes the limits it is given', () => {
    expect(() => new Re2Patterns({ length: 3 }).compile('abcd')).toThrow('more than 3');
    expect(() => new Re2Patterns({ instructions: 20 }).compile('a{30}')).toThrow(
      'at most 20 steps',
    );
  });
});
