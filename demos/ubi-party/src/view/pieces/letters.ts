import {
  CanvasTexture,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
  type BufferGeometry,
  type Material,
} from 'three';
import { identityOf, MAX_SEATS, type Seat } from '../../sim/index.ts';

const COLUMNS = 8;
const ROWS = Math.ceil(MAX_SEATS / COLUMNS);
const CELL_PX = 256;
/** Of a cell. */
const FONT_PX = 236;
const FONT = `800 ${FONT_PX}px "Bricolage Grotesque Variable", system-ui, sans-serif`;

/** The letters of all seats in one texture, as flat squares of size 1 that stand before a piece. */
export class Letters {
  readonly #canvas: HTMLCanvasElement;
  readonly #texture: CanvasTexture;
  readonly #materials = new Map<string, MeshBasicMaterial>();
  readonly #squares = new Map<Seat, BufferGeometry>();
  #isDisposed = false;

  constructor() {
    this.#canvas = document.createElement('canvas');
    this.#canvas.width = COLUMNS * CELL_PX;
    this.#canvas.height = ROWS * CELL_PX;
    this.#draw();
    this.#texture = new CanvasTexture(this.#canvas);
    this.#texture.colorSpace = SRGBColorSpace;
    this.#texture.anisotropy = 8;
    void this.#redrawWithFont();
  }

  square(seat: Seat): BufferGeometry {
    let square = this.#squares.get(seat);
    if (!square) {
      square = squareOf(seat);
      this.#squares.set(seat, square);
    }
    return square;
  }

  material(seat: Seat): Material {
    const colour = identityOf(seat).onColour.letter;
    let material = this.#materials.get(colour);
    if (!material) {
      material = new MeshBasicMaterial({
        map: this.#texture,
        color: colour,
        transparent: true,
        depthWrite: false,
      });
      this.#materials.set(colour, material);
    }
    return material;
  }

  dispose(): void {
    this.#isDisposed = true;
    this.#texture.dispose();
    for (const material of this.#materials.values()) material.dispose();
    for (const square of this.#squares.values()) square.dispose();
  }

  /** The page loads its font in its own time; until then, the letters are those of the system. */
  async #redrawWithFont(): Promise<void> {
    const fonts = await document.fonts.load(FONT, 'ABC').catch(() => []);
    if (fonts.length === 0 || this.#isDisposed) return;
    this.#draw();
    this.#texture.needsUpdate = true;
  }

  #draw(): void {
    const context = this.#canvas.getContext('2d');
    if (!context) return;
    context.clearRect(0, 0, this.#canvas.width, this.#canvas.height);
    context.font = FONT;
    context.textAlign = 'center';
    context.fillStyle = '#ffffff';
    for (let seat = 0; seat < MAX_SEATS; seat += 1) {
      const { letter } = identityOf(seat);
      const { actualBoundingBoxAscent, actualBoundingBoxDescent } = context.measureText(letter);
      const x = ((seat % COLUMNS) + 0.5) * CELL_PX;
      const y = (Math.floor(seat / COLUMNS) + 0.5) * CELL_PX;
      // A capital in the middle of its cell, also those with a tail
      context.fillText(letter, x, y + (actualBoundingBoxAscent - actualBoundingBoxDescent) / 2);
    }
  }
}

function squareOf(seat: Seat): BufferGeometry {
  const geometry = new PlaneGeometry(1, 1);
  const uv = geometry.getAttribute('uv');
  const [column, row] = [seat % COLUMNS, Math.floor(seat / COLUMNS)];
  for (let index = 0; index < uv.count; index += 1) {
    uv.setXY(index, (column + uv.getX(index)) / COLUMNS, 1 - (row + 1 - uv.getY(index)) / ROWS);
  }
  return geometry;
}
