import { describe, expect, it } from 'vitest';
import { GAMES, TRACKS } from '../../../sim/index.ts';
import { buildRoad, BRIDGE_HEIGHT, duckOf, roadHeight, ROAD_Y, underpassOf } from './road.ts';
import { freeSpots, offRoad, pillarsOf } from './scenery.ts';

describe.each(TRACKS.map((track) => [track.id, track] as const))('road of %s', (_, track) => {
  it('is closed: it ends at the height where it starts', () => {
    expect(roadHeight(track, 0)).toBeCloseTo(roadHeight(track, track.length), 9);
    expect(roadHeight(track, 0)).toBe(ROAD_Y);
  });

  it('has its surface upwards, and finite corners', () => {
    const road = buildRoad(track);
    const [position, normal] = [road.getAttribute('position'), road.getAttribute('normal')];
    // The first quad is asphalt
    for (let corner = 0; corner < 6; corner += 1) expect(normal.getY(corner)).toBeGreaterThan(0.9);
    expect(Array.from(position.array).every(Number.isFinite)).toBe(true);
  });

  it('has no tree on it', () => {
    const spots = freeSpots(track, { count: 12, radius: 2, height: 5, salt: 3 }, []);
    expect(spots.length).toBeGreaterThan(5);
    for (const spot of spots) expect(offRoad(track, spot)).toBeGreaterThan(1.9);
  });

  it('stands on pillars only where there is a bridge, and never on the road below', () => {
    const pillars = pillarsOf(track);
    if (!track.bridge) expect(pillars).toEqual([]);
    else expect(pillars.length).toBeGreaterThan(3);
  });
});

describe('the bridge', () => {
  const track = TRACKS.find(({ bridge }) => bridge)!;

  it('is up where carts jump, and over the road below', () => {
    const middle = ((track.bridge!.from + track.bridge!.to) / 2) * track.length;
    expect(roadHeight(track, middle)).toBeCloseTo(ROAD_Y + BRIDGE_HEIGHT, 6);
    const under = underpassOf(track)!;
    expect(roadHeight(track, under)).toBeLessThan(1);
  });

  it('hides nobody on the grid', () => {
    const seats = Array.from({ length: 12 }, (_, seat) => seat);
    const { carts } = GAMES.race.start({ seats, seed: TRACKS.indexOf(track) });
    const under = underpassOf(track);
    for (const { distance } of carts) expect(duckOf(track, under, distance)).toBe(0);
  });

  it('lets tokens duck below it, on each lap, and nowhere else', () => {
    const under = underpassOf(track)!;
    expect(duckOf(track, under, under + track.length * 2)).toBe(1);
    expect(duckOf(track, under, under + track.length / 2)).toBe(0);
    expect(duckOf(track, undefined, under)).toBe(0);
  });
});
