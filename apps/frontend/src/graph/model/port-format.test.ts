import { describe, expect, it } from 'vitest';
import { portFormat } from './port-format.ts';
import { aGraphOf, aModule } from './testing/small-graph.ts';

describe('the format of a topic that nobody has published yet', () => {
  // A topic with one writer and one reader is a wire between them.
  const writers = [aModule('writer', {}, { out: 'int32' }), aModule('other', {}, { out: 'int32' })];
  const reader = aModule('reader', { in: 'double' });
  const formatBetween = (...modules: (typeof reader)[]) =>
    portFormat(aGraphOf(modules, { 'writer.out': '/t', 'other.out': '/t', 'reader.in': '/t' }), {
      node: 'topic:/t',
      port: 'out',
    });

  it('is that of its writers, else that of its reader', () => {
    expect(formatBetween(...writers, reader)).toBe('int32');
    expect(formatBetween(reader, ...writers)).toBe('int32');
  });

  it('is that of its reader while nobody writes it', () => {
    expect(formatBetween(reader)).toBe('double');
  });
});
