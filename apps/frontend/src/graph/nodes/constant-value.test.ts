import { describe, expect, it } from 'vitest';
import { constantText, defaultConstant, typedConstant } from './constant-value.ts';

describe('constants [PM-34]', () => {
  it('are typed as people write them', () => {
    expect(typedConstant('double', ' 0,35 ').json).toBe('{"double":0.35}');
    expect(typedConstant('double', '−2').json).toBe('{"double":-2}');
    expect(typedConstant('bool', 'true').json).toBe('{"bool":true}');
    expect(typedConstant('string', ' a ').json).toBe('{"string":" a "}');
    expect(typedConstant('vector2', '{"x":1,"y":2}').json).toBe('{"vector2":{"x":1,"y":2}}');
  });

  it('say what is wrong with them', () => {
    expect(typedConstant('double', '').problem).toMatch(/number/);
    expect(typedConstant('int32', 'x').problem).toMatch(/number/);
    expect(typedConstant('bool', 'yes').problem).toMatch(/true or false/);
    expect(typedConstant('vector2', '{x').problem).toMatch(/JSON/);
    expect(typedConstant('vector2', '"x"').problem).toMatch(/valid vector2/);
  });

  it('show as they are typed, also those that cannot be read', () => {
    expect(constantText('{"double":0.35}')).toBe('0.35');
    expect(constantText('{"vector2":{"x":1,"y":2}}')).toBe('{"x":1,"y":2}');
    expect(constantText('{broken')).toBe('{broken');
  });

  it('begin with a value that the master takes', () => {
    expect(constantText(defaultConstant('double'))).toBe('0');
    expect(
      typedConstant('vector3', constantText(defaultConstant('vector3'))).problem,
    ).toBeUndefined();
  });
});
