import { CylinderGeometry, Group, Mesh, SphereGeometry, type BufferGeometry } from 'three';
import { identityOf, type Seat } from '../../../sim/index.ts';
import type { Paints } from '../../light/paints.ts';
import { merged } from '../../toys/crown.ts';
import { WOOD } from '../../toys/toy-box.ts';
import { buildBlock } from '../../toys/turned.ts';

const WHEEL = 0.66;
/** Height at which the token stands, units. */
export const SEAT_Y = 1.45;

/** The forms of a cart: it points along +x, its wheels stand on y = 0. */
export interface CartForms {
  readonly body: BufferGeometry;
  readonly axle: BufferGeometry;
  readonly hubs: BufferGeometry;
  /** One unit high, from y = 0. */
  readonly mast: BufferGeometry;
}

export function buildCartForms(): CartForms {
  const body = merged([
    buildBlock(3.7, 0.62, 1.7, 0.2).translate(0, 0.55, 0),
    buildBlock(1.9, 0.42, 1.45, 0.16).translate(-0.45, 1.08, 0),
    buildBlock(0.5, 0.5, 1.9, 0.16).translate(1.75, 0.5, 0),
  ]);
  const sides = [-1, 1] as const;
  const axle = merged(
    sides.map((side) => new SphereGeometry(WHEEL, 24, 18).translate(0, 0, side * 1.05)),
  );
  const hubs = merged(
    sides.map((side) => new SphereGeometry(0.26, 14, 10).translate(0, 0, side * 1.5)),
  );
  const mast = new CylinderGeometry(0.2, 0.24, 1, 14).translate(0, 0.5, 0);
  return { body, axle, hubs, mast };
}

/** A cart in the colour of a seat, on four marbles. */
export class CartModel {
  /** Turns with the heading. */
  readonly root = new Group();
  readonly #axles: readonly Group[];
  readonly #mast: Mesh;

  constructor(seat: Seat, forms: CartForms, paints: Paints) {
    const { colour } = identityOf(seat);
    // A black cart is seen by its marbles
    const [tyre, hub] = colour === '#221c14' ? ['#fff6e4', '#221c14'] : ['#221c14', '#fff6e4'];
    const body = new Mesh(forms.body, paints.of(colour));
    this.#axles = [-1.15, 1.15].map((x) => {
      const axle = new Group();
      axle.position.set(x, WHEEL, 0);
      axle.add(
        new Mesh(forms.axle, paints.of(tyre!, 'marble')),
        new Mesh(forms.hubs, paints.of(hub!)),
      );
      return axle;
    });
    this.#mast = new Mesh(forms.mast, paints.of(WOOD));
    this.#mast.position.y = SEAT_Y - 0.2;
    this.root.add(body, this.#mast, ...this.#axles);
    this.root.traverse((part) => {
      part.castShadow = true;
      part.receiveShadow = true;
    });
  }

  /** Puts the token on a mast. @param height units above the seat */
  raise(height: number): void {
    this.#mast.visible = height > 0.05;
    this.#mast.scale.y = height + 0.4;
  }

  /** @param distance units driven */
  roll(distance: number): void {
    for (const axle of this.#axles) axle.rotation.z = -distance / WHEEL;
  }
}
