import { CanvasTexture, SRGBColorSpace, type Texture } from 'three';
import type { Hour } from './hours.ts';

const WIDTH_PX = 1920;

/** The seamless ground behind everything: drawn flat, so that its colours are exactly those of the hour. */
export class Backdrop {
  readonly texture: Texture;
  readonly #canvas = document.createElement('canvas');
  #key = '';

  constructor() {
    this.texture = new CanvasTexture(this.#canvas);
    this.texture.colorSpace = SRGBColorSpace;
    this.texture.generateMipmaps = false;
  }

  /** @param aspect of the picture; nothing is drawn twice */
  paint(name: string, hour: Hour, aspect: number): void {
    const key = `${name} ${aspect.toFixed(3)}`;
    if (key === this.#key) return;
    this.#key = key;
    this.#canvas.width = WIDTH_PX;
    this.#canvas.height = Math.max(1, Math.round(WIDTH_PX / aspect));
    const context = this.#canvas.getContext('2d');
    if (!context) return;
    paintHour(context, hour, this.#canvas.width, this.#canvas.height);
    // The size may have changed: a texture of another size is another texture
    this.texture.dispose();
    this.texture.needsUpdate = true;
  }

  dispose(): void {
    this.texture.dispose();
  }
}

function paintHour(
  context: CanvasRenderingContext2D,
  hour: Hour,
  width: number,
  height: number,
): void {
  const down = context.createLinearGradient(0, 0, 0, height);
  down.addColorStop(0, hour.horizon);
  if (!hour.sun) {
    down.addColorStop(0.45, hour.middle);
    down.addColorStop(1, hour.ground);
  } else {
    down.addColorStop(hour.sun.skyline - 0.06, hour.horizon);
    down.addColorStop(hour.sun.skyline + 0.14, hour.middle);
    down.addColorStop(1, hour.ground);
  }
  context.fillStyle = down;
  context.fillRect(0, 0, width, height);
  if (hour.sun) paintSun(context, hour.sun, width, height);
  else paintPool(context, hour, width, height);
}

/** The light lies in the middle, and fades to the corners. */
function paintPool(
  context: CanvasRenderingContext2D,
  hour: Hour,
  width: number,
  height: number,
): void {
  const pool = context.createRadialGradient(
    width * 0.55,
    height * 0.5,
    height * 0.1,
    width * 0.55,
    height * 0.5,
    width * 0.62,
  );
  pool.addColorStop(0, `${hour.middle}cc`);
  pool.addColorStop(1, `${hour.middle}00`);
  context.fillStyle = pool;
  context.fillRect(0, 0, width, height);
}

const RAYS = 18;

function paintSun(
  context: CanvasRenderingContext2D,
  sun: NonNullable<Hour['sun']>,
  width: number,
  height: number,
): void {
  const [x, y] = [sun.x * width, sun.y * height];
  context.save();
  context.beginPath();
  context.rect(0, 0, width, sun.skyline * height);
  context.clip();
  context.fillStyle = sun.ray;
  context.beginPath();
  for (let ray = 0; ray < RAYS; ray += 1) {
    const [from, to] = [ray, ray + 0.5].map((turn) => (turn / RAYS) * Math.PI * 2 + 0.09);
    context.moveTo(x, y);
    context.lineTo(x + Math.cos(from!) * width * 2, y + Math.sin(from!) * width * 2);
    context.lineTo(x + Math.cos(to!) * width * 2, y + Math.sin(to!) * width * 2);
    context.closePath();
  }
  context.fill();
  context.fillStyle = sun.colour;
  context.beginPath();
  context.arc(x, y, sun.radius * height, 0, Math.PI * 2);
  context.fill();
  context.restore();
}
