import { describe, expect, it } from 'vitest';
import {
  controlFormat,
  readButtonSettings,
  readIsSurface,
  readSliderSettings,
} from './control-settings.ts';
import {
  BUTTON_FORMATS,
  buttonValue,
  readNumber,
  SLIDER_FORMATS,
  sliderRange,
  sliderValue,
} from './control-values.ts';

describe('settings of controls', () => {
  it('are read from links, which may hold anything', () => {
    expect(readSliderSettings({ min: 0, max: 5, step: 0.5 })).toEqual({
      min: 0,
      max: 5,
      step: 0.5,
    });
    expect(readSliderSettings({ min: 5, max: 5, step: -1 })).toEqual({});
    expect(readSliderSettings({ min: '0', max: null })).toEqual({});
    expect(readButtonSettings({ mode: 'explode', on: 7 })).toEqual({ mode: 'hold' });
    expect(readButtonSettings({ mode: 'toggle', on: 'x'.repeat(201) })).toEqual({ mode: 'toggle' });
    expect([readIsSurface({ surface: true }), readIsSurface({ surface: 1 })]).toEqual([
      true,
      false,
    ]);
  });

  it('have a data format that the control sends', () => {
    expect(controlFormat({ format: 'int32' }, SLIDER_FORMATS)).toBe('int32');
    expect(controlFormat({ format: 'image2D' }, SLIDER_FORMATS)).toBe('double');
    expect(controlFormat({}, BUTTON_FORMATS)).toBe('bool');
  });
});

describe('range of a slider', () => {
  const none = readSliderSettings({});

  it('contains all values so far', () => {
    expect(sliderRange(none, 'double', { lowest: 0, highest: 0.4 })).toEqual({
      min: 0,
      max: 1,
      step: 0.01,
    });
    expect(sliderRange(none, 'double', { lowest: -30, highest: 2 })).toMatchObject({
      min: -100,
      max: 100,
    });
  });

  it('is the one that was set, also with one end', () => {
    const set = readSliderSettings({ min: 20, max: 25, step: 0.1 });
    expect(sliderRange(set, 'double', { lowest: 0, highest: 90 })).toEqual({
      min: 20,
      max: 25,
      step: 0.1,
    });
    expect(
      sliderRange(readSliderSettings({ min: 50 }), 'double', { lowest: 0, highest: 0 }),
    ).toEqual({ min: 50, max: 51, step: 0.01 });
    expect(
      sliderRange(readSliderSettings({ max: -5 }), 'double', { lowest: 0, highest: 0 }),
    ).toMatchObject({ min: -6, max: -5 });
  });

  it('has whole numbers for int32', () => {
    const set = readSliderSettings({ min: 0.5, max: 4.5, step: 0.2 });
    expect(sliderRange(set, 'int32', { lowest: 0, highest: 0 })).toEqual({
      min: 1,
      max: 4,
      step: 1,
    });
  });

  it('gives values without rounding errors', () => {
    expect(sliderValue(0.1 + 0.2)).toBe(0.3);
  });
});

describe('value of a button', () => {
  it('is of the data format', () => {
    const settings = readButtonSettings({ on: '2,5' });
    expect(buttonValue(settings, 'bool', 'on')).toBe(true);
    expect(buttonValue(settings, 'double', 'on')).toBe(2.5);
    expect(buttonValue(settings, 'double', 'off')).toBe(0);
    expect(buttonValue(settings, 'int32', 'on')).toBeUndefined();
    expect(buttonValue(settings, 'string', 'on')).toBe('2,5');
    expect(buttonValue(readButtonSettings({}), 'string', 'off')).toBe('off');
  });

  it('reads numbers as typed', () => {
    expect([readNumber(' −3 ', 'int32'), readNumber('1e999', 'double')]).toEqual([-3, undefined]);
    expect([readNumber('', 'double'), readNumber('3000000000', 'int32')]).toEqual([
      undefined,
      undefined,
    ]);
  });
});
