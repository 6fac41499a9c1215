import { DATA_FORMATS, type DataFormat } from '@ubii/proto';
import { describe, expect, it } from 'vitest';
import { partsOf, readNumber } from './number-fields.ts';
import { seriesOf, sparkNumbers } from './value-series.ts';

describe('seriesOf', () => {
  it('reads a number for each name', () => {
    for (const { format, createDefault } of Object.values(DATA_FORMATS)) {
      const series = seriesOf(format);
      if (series) expect(series.read(createDefault() as never)).toHaveLength(series.names.length);
      if (series) expect(series.paths).toHaveLength(series.names.length);
    }
  });

  it('names the members of a vector', () => {
    expect(seriesOf('vector3')?.names).toEqual(['x', 'y', 'z']);
    expect(seriesOf('vector3')?.read({ x: 1, y: 2, z: 3 } as never)).toEqual([1, 2, 3]);
    expect(seriesOf('string')).toBeUndefined();
  });
});

it('says where the numbers stand', () => {
  for (const { format, createDefault } of Object.values(DATA_FORMATS)) {
    const series = seriesOf(format);
    const value = createDefault();
    const read = series?.paths.map((path) => readNumber(value, partsOf(path)));
    expect(read, format).toEqual(series?.read(value as never));
  }
});

describe('sparkNumbers', () => {
  it.each<[DataFormat, unknown, readonly number[]]>([
    ['double', 4.5, [4.5]],
    ['bool', true, [1]],
    ['vector2', { x: 3, y: 4 }, [3, 4]],
    ['doubleList', { elements: [7, 8] }, [7]],
    ['doubleList', { elements: [] }, []],
    ['string', 'x', []],
  ])('%s', (format, value, numbers) => {
    expect(sparkNumbers(format, value)).toEqual(numbers);
  });
});
