import {
  CatmullRomCurve3,
  CylinderGeometry,
  ExtrudeGeometry,
  Group,
  Mesh,
  Shape,
  TorusGeometry,
  TubeGeometry,
  Vector3,
  type BufferGeometry,
} from 'three';
import type { Power } from '../../sim/index.ts';
import type { Paints } from '../light/paints.ts';
import { merged } from './piece-parts.ts';
import { buildCylinder } from './turned.ts';

/** The three powers as toys that stand on y = 0, about 1.5 units high. */
export function buildPower(kind: Power, paints: Paints): Group {
  const toy = new Group();
  const add = (geometry: BufferGeometry, ...paint: Parameters<Paints['of']>): void => {
    const mesh = new Mesh(geometry, paints.of(...paint));
    mesh.castShadow = true;
    mesh.receiveShadow = true;
    toy.add(mesh);
  };
  switch (kind) {
    case 'spring':
      add(
        merged([buildCylinder(0.5, 0.24), buildCylinder(0.5, 0.24).translate(0, 1.2, 0)]),
        '#e8674f',
      );
      add(buildCoil(), '#eef1f2', 'marble');
      return toy;
    case 'anchor':
      add(buildAnchor(), '#39415f', 'marble');
      return toy;
    case 'feather':
      add(buildFeather(), '#fff6e4');
      add(
        new CylinderGeometry(0.035, 0.05, 1.75, 8).rotateZ(-0.22).translate(0, 0.85, 0.06),
        '#c9a877',
      );
      return toy;
  }
}

const COILS = 4;

export function buildCoil(): BufferGeometry {
  const points = Array.from({ length: COILS * 16 + 1 }, (_, index) => {
    const angle = (index / 16) * Math.PI * 2;
    return new Vector3(
      Math.cos(angle) * 0.38,
      0.26 + (index / (COILS * 16)) * 0.94,
      Math.sin(angle) * 0.38,
    );
  });
  return new TubeGeometry(new CatmullRomCurve3(points), COILS * 24, 0.075, 8);
}

function buildAnchor(): BufferGeometry {
  const hook = new TorusGeometry(0.58, 0.13, 12, 24, Math.PI)
    .rotateZ(Math.PI)
    .translate(0, 0.72, 0);
  const eye = new TorusGeometry(0.19, 0.08, 10, 20).translate(0, 1.5, 0);
  const stem = new CylinderGeometry(0.12, 0.12, 1.2, 14).translate(0, 0.74, 0);
  const bar = new CylinderGeometry(0.1, 0.1, 0.8, 12).rotateZ(Math.PI / 2).translate(0, 1.14, 0);
  const flukes = [-1, 1].map((side) =>
    new CylinderGeometry(0.02, 0.24, 0.36, 4).rotateY(Math.PI / 4).translate(side * 0.58, 0.84, 0),
  );
  return merged([hook, eye, stem, bar, ...flukes]);
}

function buildFeather(): BufferGeometry {
  const shape = new Shape();
  shape.moveTo(0, 0.35);
  shape.bezierCurveTo(0.75, 0.6, 0.7, 1.5, 0.22, 1.85);
  shape.bezierCurveTo(-0.2, 1.6, -0.5, 0.9, 0, 0.35);
  return new ExtrudeGeometry(shape, {
    depth: 0.06,
    bevelSize: 0.03,
    bevelThickness: 0.03,
    bevelSegments: 2,
    curveSegments: 12,
  }).translate(-0.1, 0, -0.05);
}
