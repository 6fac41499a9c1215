import { DEFAULT_DICTIONARY, markerCells, markerDictionary } from '@ubii/vision/markers';

/** Side length of the markers in the clip, metres. */
export const CLIP_MARKER_METRES = 0.06;
/** Field of view along the clip's longer side, equal to the module's assumption without calibration. */
const FIELD_OF_VIEW_DEGREES = 60;

/** Period of the rotating marker, milliseconds. */
const TURN_MS = 12_000;

/** A marker in the camera coordinates of the clip: metres and radians, as the module outputs them. */
interface ClipMarker {
  readonly id: number;
  readonly x: number;
  readonly y: number;
  readonly z: number;
  readonly yaw: number;
  readonly pitch: number;
  readonly roll: number;
}

/** Returns the poses of the clip's three markers at a time. */
export function clipMarkers(timeMs: number): readonly ClipMarker[] {
  const turn = (timeMs / TURN_MS) * 2 * Math.PI;
  return [
    { id: 7, x: -0.09, y: 0.03, z: -0.34, yaw: 0.6 * Math.sin(turn), pitch: 0.35, roll: 0 },
    { id: 12, x: 0.02, y: -0.05, z: -0.3, yaw: 0.2, pitch: -0.5, roll: turn },
    {
      id: 23,
      x: 0.12,
      y: 0.04,
      z: -0.42 - 0.1 * Math.sin(turn / 2),
      yaw: -0.5,
      pitch: 0.3 * Math.cos(turn),
      roll: 0.2,
    },
  ];
}

/** Draws a frame of the clip: markers on white cards, in perspective. */
export function drawMarkerClip(canvas: HTMLCanvasElement, timeMs: number): void {
  const context = canvas.getContext('2d')!;
  const { width, height } = canvas;
  context.fillStyle = 'dimgray';
  context.fillRect(0, 0, width, height);
  const focal = Math.max(width, height) / 2 / Math.tan((FIELD_OF_VIEW_DEGREES * Math.PI) / 360);
  const dictionary = markerDictionary(DEFAULT_DICTIONARY);
  for (const marker of clipMarkers(timeMs)) {
    const place = placeOn(marker);
    const quad = (left: number, top: number, right: number, bottom: number): void => {
      for (const [index, [across, up]] of [
        [left, top],
        [right, top],
        [right, bottom],
        [left, bottom],
      ].entries()) {
        const { x, y, z } = place(across!, up!);
        const at = [width / 2 - (focal * x) / z, height / 2 + (focal * y) / z] as const;
        if (index === 0) context.moveTo(...at);
        else context.lineTo(...at);
      }
      context.closePath();
    };
    const cells = markerCells(dictionary, marker.id);
    const cell = CLIP_MARKER_METRES / cells.length;
    const half = CLIP_MARKER_METRES / 2;
    context.fillStyle = 'white';
    context.beginPath();
    quad(-half - cell, half + cell, half + cell, -half - cell);
    context.fill();
    context.fillStyle = 'black';
    context.beginPath();
    for (const [row, line] of cells.entries()) {
      for (const [column, isBlack] of line.entries()) {
        if (!isBlack) continue;
        const [left, top] = [column * cell - half, half - row * cell];
        quad(left, top, left + cell, top - cell);
      }
    }
    context.fill();
  }
}

/** Converts marker coordinates to camera coordinates: rotated about its z, x and y, in this order. */
function placeOn({ x, y, z, yaw, pitch, roll }: ClipMarker) {
  return (across: number, up: number) => {
    const rolled = {
      x: across * Math.cos(roll) - up * Math.sin(roll),
      y: across * Math.sin(roll) + up * Math.cos(roll),
    };
    const pitched = { y: rolled.y * Math.cos(pitch), z: rolled.y * Math.sin(pitch) };
    return {
      x: x + rolled.x * Math.cos(yaw) + pitched.z * Math.sin(yaw),
      y: y + pitched.y,
      z: z - rolled.x * Math.sin(yaw) + pitched.z * Math.cos(yaw),
    };
  };
}
