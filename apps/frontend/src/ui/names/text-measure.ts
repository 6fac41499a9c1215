import { shallowRef } from 'vue';
import type { MeasureText } from './fit-text.ts';

/** Most cached widths, over all fonts. */
const MAX_REMEMBERED = 5000;
const widths = new Map<string, number>();
/** Incremented when fonts are loaded, which invalidates earlier measurements. */
const fonts = shallowRef(0);
document.fonts?.addEventListener('loadingdone', () => {
  widths.clear();
  fonts.value++;
});
let context: CanvasRenderingContext2D | null | undefined;

/** @param font in CSS syntax; when it is loaded, effects that measured with it run again */
export function textMeasure(font: string): MeasureText {
  return (text) => {
    void fonts.value;
    const key = `${font} ${text}`;
    const known = widths.get(key);
    if (known !== undefined) return known;
    context ??= document.createElement('canvas').getContext('2d');
    if (!context) return 0;
    context.font = font;
    const { width } = context.measureText(text);
    if (widths.size >= MAX_REMEMBERED) widths.clear();
    widths.set(key, width);
    return width;
  };
}
