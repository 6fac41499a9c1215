import {
  CanvasTexture,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
  type BufferGeometry,
} from 'three';

const COLUMNS = 8;
const CELL_PX = 256;
/** Of a cell. */
const FONT_PX = 236;
const FONT = `800 ${FONT_PX}px "Bricolage Grotesque Variable", system-ui, sans-serif`;

/** Letters or digits in one texture, as flat squares of size 1. */
export class GlyphSheet {
  readonly #glyphs: readonly string[];
  readonly #rows: number;
  readonly #canvas: HTMLCanvasElement;
  readonly #texture: CanvasTexture;
  readonly #materials = new Map<string, MeshBasicMaterial>();
  readonly #squares = new Map<number, BufferGeometry>();
  #isDisposed = false;

  constructor(glyphs: readonly string[]) {
    this.#glyphs = glyphs;
    this.#rows = Math.ceil(glyphs.length / COLUMNS);
    this.#canvas = document.createElement('canvas');
    this.#canvas.width = COLUMNS * CELL_PX;
    this.#canvas.height = this.#rows * CELL_PX;
    this.#draw();
    this.#texture = new CanvasTexture(this.#canvas);
    this.#texture.colorSpace = SRGBColorSpace;
    this.#texture.anisotropy = 8;
    void this.#redrawWithFont();
  }

  square(index: number): BufferGeometry {
    let square = this.#squares.get(index);
    if (!square) {
      square = this.#cut(index);
      this.#squares.set(index, square);
    }
    return square;
  }

  /** Unlit: a letter has the same colour on each side of a scene. */
  material(colour: string): MeshBasicMaterial {
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
    for (const [index, glyph] of this.#glyphs.entries()) {
      const { actualBoundingBoxAscent, actualBoundingBoxDescent } = context.measureText(glyph);
      const x = ((index % COLUMNS) + 0.5) * CELL_PX;
      const y = (Math.floor(index / COLUMNS) + 0.5) * CELL_PX;
      // A capital in the middle of its cell, also those with a tail
      context.fillText(glyph, x, y + (actualBoundingBoxAscent - actualBoundingBoxDescent) / 2);
    }
  }

  #cut(index: number): BufferGeometry {
    const geometry = new PlaneGeometry(1, 1);
    const uv = geometry.getAttribute('uv');
    const [column, row] = [index % COLUMNS, Math.floor(index / COLUMNS)];
    for (let corner = 0; corner < uv.count; corner += 1) {
      const u = (column + uv.getX(corner)) / COLUMNS;
      uv.setXY(corner, u, 1 - (row + 1 - uv.getY(corner)) / this.#rows);
    }
    return geometry;
  }
}
