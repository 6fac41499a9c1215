import { formatNumber } from '../../ui/readouts/format-number.ts';
import type { Finger } from './fingers.ts';

/** Colours and fonts, read once from the style tokens. */
export interface PadInk {
  readonly finger: string;
  readonly line: string;
  readonly paper: string;
  readonly ink: string;
  readonly dim: string;
  readonly font: string;
}

export function readPadInk(element: Element): PadInk {
  const style = getComputedStyle(element);
  // Canvases do not resolve custom properties and light-dark(): read them from an element.
  const probe = document.createElement('span');
  element.append(probe);
  const colorOf = (token: string): string => {
    probe.style.color = `var(${token})`;
    return getComputedStyle(probe).color;
  };
  const ink = {
    finger: colorOf('--family-vector'),
    line: colorOf('--line-2'),
    paper: colorOf('--s1'),
    ink: colorOf('--ink-1'),
    dim: colorOf('--ink-3'),
    font: `12px ${style.getPropertyValue('--font-mono')}`,
  };
  probe.remove();
  return ink;
}

const RADIUS = 30;
const LABEL = { height: 20, padding: 8, gap: 10 };

/** Draws crosshair, trail, disc and coordinates of each finger. Lengths in CSS pixels. */
export function drawFingers(
  context: CanvasRenderingContext2D,
  size: { readonly width: number; readonly height: number },
  fingers: readonly Finger[],
  ink: PadInk,
): void {
  context.clearRect(0, 0, size.width, size.height);
  for (const { number, at, trail } of fingers) {
    const x = at.x * size.width;
    const y = at.y * size.height;
    context.strokeStyle = ink.finger;
    context.globalAlpha = 0.45;
    context.lineWidth = 1;
    context.beginPath();
    context.moveTo(0, y);
    context.lineTo(size.width, y);
    context.moveTo(x, 0);
    context.lineTo(x, size.height);
    context.stroke();

    context.globalAlpha = 0.6;
    context.lineWidth = 2;
    context.beginPath();
    for (const point of trail) context.lineTo(point.x * size.width, point.y * size.height);
    context.stroke();

    context.globalAlpha = 0.14;
    context.fillStyle = ink.finger;
    context.beginPath();
    context.arc(x, y, RADIUS, 0, 2 * Math.PI);
    context.fill();
    context.globalAlpha = 1;
    context.stroke();
    context.beginPath();
    context.arc(x, y, 3, 0, 2 * Math.PI);
    context.fill();
    drawLabel(context, size, { x, y }, [String(number), coordinates(at)], ink);
  }
}

function drawLabel(
  context: CanvasRenderingContext2D,
  size: { readonly width: number; readonly height: number },
  { x, y }: { x: number; y: number },
  [number, text]: readonly [string, string],
  ink: PadInk,
): void {
  context.font = ink.font;
  const numberWidth = context.measureText(`${number} `).width;
  const width = Math.ceil(numberWidth + context.measureText(text).width) + 2 * LABEL.padding;
  // Beside the finger towards the outside, so that labels of two fingers do not overlap; inside at an edge.
  const distance = RADIUS + LABEL.gap;
  const isLeft = x < size.width / 2 ? x > distance + width : x + distance + width > size.width;
  const left = Math.round(isLeft ? x - distance - width : x + distance);
  const top = Math.round(y < size.height / 2 ? y - RADIUS : y + RADIUS - LABEL.height);
  context.fillStyle = ink.paper;
  context.strokeStyle = ink.line;
  context.lineWidth = 1;
  context.beginPath();
  context.roundRect(left + 0.5, top + 0.5, width, LABEL.height, 4);
  context.fill();
  context.stroke();
  context.textBaseline = 'middle';
  const middle = top + LABEL.height / 2 + 1;
  context.fillStyle = ink.dim;
  context.fillText(number, left + LABEL.padding, middle);
  context.fillStyle = ink.ink;
  context.fillText(text, left + LABEL.padding + numberWidth, middle);
}

/** `.412 .413`: three decimals, no leading zero. */
function coordinates({ x, y }: { readonly x: number; readonly y: number }): string {
  return [x, y].map((value) => formatNumber(value, 3).replace(/^0\./, '.')).join(' ');
}
