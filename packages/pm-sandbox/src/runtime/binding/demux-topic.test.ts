import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { demuxTopic, hasPlaceholder, parseDemuxFormat } from './demux-topic.ts';

const topicOf = (format: string, params?: readonly string[], identity?: string) =>
  demuxTopic(parseDemuxFormat(format), params, identity);

describe('[PM-45] the topic of an element', () => {
  it.each<[string, string[] | undefined, string | undefined, string]>([
    ['/{{#0}}/{{#1}}', ['a', 'b'], undefined, '/a/b'],
    ['/{{#1}}/{{#0}}', ['a', 'b'], undefined, '/b/a'],
    ['/{{#0}}/x/{{#0}}', ['a'], undefined, '/a/x/a'],
    ['/{{#10}}', '0123456789z'.split(''), undefined, '/z'],
    ['/%s/x/%s', ['a', 'b'], undefined, '/a/x/b'],
    ['/%s/{{#0}}', ['a', 'b'], undefined, '/%s/a'],
    ['/{{identity}}/x', ['a'], 'me', '/me/x'],
    ['/{{identity}}/{{#0}}', ['a'], 'me', '/me/a'],
    ['/{{identity}}/%s', ['a'], 'me', '/me/a'],
    ['/fixed', undefined, undefined, '/fixed'],
    ['/{{#0}}', ['{{#1}}$&%s'], undefined, '/{{#1}}$&%s'],
    ['/{{#}}/{{#x}}/{{ #0 }}', ['a'], undefined, '/{{#}}/{{#x}}/{{ #0 }}'],
  ])('of %s with %j and identity %s is %s', (format, params, identity, topic) => {
    expect(topicOf(format, params, identity)).toEqual({ topic });
  });

  it.each(['/{{#0}}/x', '/%s/x', '/{{identity}}/x'])(
    '[PM-46] takes the identity for the only parameter in %s',
    (format) => {
      expect(topicOf(format, undefined, 'me')).toEqual({ topic: '/me/x' });
    },
  );

  it.each<[string, string[] | undefined, string | undefined, RegExp]>([
    [
      '/{{#0}}/{{#2}}',
      ['a', 'b'],
      undefined,
      /^the topic needs the parameter 2, outputTopicParams has 2$/,
    ],
    ['/%s/%s', ['a'], undefined, /^the topic needs the parameter 1, outputTopicParams has 1$/],
    [
      '/{{#0}}',
      undefined,
      undefined,
      /^the topic needs the parameter 0, outputTopicParams has none$/,
    ],
    ['/{{#0}}', [], 'me', /needs the parameter 0/],
    ['/{{#1}}', undefined, 'me', /needs the parameter 1/],
    ['/{{identity}}', ['a'], undefined, /needs an identity/],
  ])('[PM-47] of %s with %j and identity %s lacks something', (format, params, identity, lacks) => {
    expect(topicOf(format, params, identity)).toEqual({ lacks: expect.stringMatching(lacks) });
  });

  it('[SE-4] tells whether a format has a placeholder', () => {
    const has = (format: string) => hasPlaceholder(parseDemuxFormat(format));
    expect(['/a', '/{{#0}}', '/%s', '/{{identity}}', '/{{#a}}'].map(has)).toEqual([
      false,
      true,
      true,
      true,
      false,
    ]);
  });

  it('puts every parameter where its number is, as it is', () => {
    const text = fc.string().filter((value) => !/\{\{(#\d+|identity)\}\}/.test(value));
    const piece = fc.oneof(
      text.map((value) => ({ format: value, topic: () => value })),
      fc.nat(3).map((index) => ({
        format: `{{#${index}}}`,
        topic: (params: readonly string[]) => params[index]!,
      })),
    );
    const params = fc.array(fc.string(), { minLength: 4, maxLength: 4 });
    fc.assert(
      fc.property(fc.array(piece), params, (pieces, values) => {
        const format = `{{#0}}${pieces.map((each) => each.format).join('|')}`;
        const expected = values[0] + pieces.map((each) => each.topic(values)).join('|');
        expect(topicOf(format, values)).toEqual({ topic: expected });
      }),
    );
  });

  it('fills %s one after the other', () => {
    fc.assert(
      fc.property(fc.array(fc.string(), { minLength: 1 }), (values) => {
        expect(topicOf(values.map(() => '%s').join('/'), values)).toEqual({
          topic: values.join('/'),
        });
      }),
    );
  });
});
