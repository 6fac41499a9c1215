import { GAMES, type Game, type GameId, type Seat } from '@ubii/party/sim';
import { stateTopic, type RoomView } from '@ubii/party/net';
import type { RoundState } from '@ubii/party/modules';
import { expect, test } from '../../fixtures/test.ts';
import { PartyPhonePage, PartyScreenPage } from '../../pages/party-pages.ts';

const CHOICE = [
  ...['Quick Draw', 'Photo Hunt', 'Marble Dash', 'King of the Hill'],
  ...['King of the Hill', 'Marble Dash', 'Tilt Quiz'],
];

test('four phones play a tournament by touch: one reloads, one leaves, one comes late', async ({
  room,
}) => {
  test.setTimeout(600_000);
  const screen = new PartyScreenPage((await room.atDesk('Big screen')).page);
  await screen.open();
  const phones: PartyPhonePage[] = [];
  for (const name of ['Mara', 'Theo', 'Ines', 'Jo']) {
    const phone = new PartyPhonePage((await room.withPhone()).page, name);
    await phone.join();
    phones.push(phone);
  }
  const [mara, theo, ines, jo] = phones as [
    PartyPhonePage,
    PartyPhonePage,
    PartyPhonePage,
    PartyPhonePage,
  ];
  await screen.expectPlayers(4);

  // State that the players see: seats, and the newest state of each game.
  const eyes = await room.program('eyes');
  const seen = new Map<GameId, RoundState>();
  for (const game of Object.keys(GAMES) as GameId[]) {
    const states = eyes.subscribe(stateTopic(game), { format: 'string' });
    states.onRecord(({ value }) => seen.set(game, JSON.parse(value) as RoundState));
    await states.ready;
  }
  let view: RoomView | undefined;
  const rooms = eyes.subscribe('/party/room', { format: 'string' });
  rooms.onRecord(({ value }) => (view = JSON.parse(value) as RoomView));
  await rooms.ready;
  const seatOf = (phone: PartyPhonePage): Seat =>
    view!.room.players.find(({ name }) => name === phone.name)!.seat;
  /** All are ready, in the podium and in the explanation, until a round is played. */
  const playOn = async (who: readonly PartyPhonePage[]): Promise<void> => {
    const played = view!.room.results.length;
    while (view!.room.phase !== 'play' || view!.room.results.length > played) {
      for (const phone of who) {
        const { phase, players } = view!.room;
        const isAsked = phase === 'podium' || phase === 'explanation';
        if (isAsked && players[seatOf(phone)]?.isReady === false) await phone.ready();
      }
      await screen.page.waitForTimeout(200);
    }
  };
  /** Players do what the game's own bot would, with their thumbs, until the round is over. */
  const playOut = async (game: GameId, who: readonly PartyPhonePage[]): Promise<void> => {
    const rules = GAMES[game] as unknown as Game<unknown>;
    while (view?.room.phase === 'play') {
      const state = seen.get(game);
      for (const phone of who) {
        if (!state || state.id !== view.round?.id) continue;
        const { x, y, isPressed } = rules.bot(state.state, seatOf(phone));
        if (rules.controller.steering !== 'none') await phone.steer(x, y);
        if (isPressed) await phone.press();
      }
      await screen.page.waitForTimeout(30);
    }
    for (const phone of who) await phone.release();
    await screen.expectPhase('podium');
  };

  await test.step('Quick Draw', async () => {
    // Quick Draw in, Photo Hunt out; taken out and in again, games come last
    for (const game of CHOICE) {
      await screen.page.getByRole('button', { name: game }).click();
    }
    await screen.start();
    await playOn(phones);
    await playOut('duel', phones);
    expect(view!.room.results[0]!.places.flat().sort()).toEqual([0, 1, 2, 3]);
  });

  await test.step('King of the Hill: a phone reloads in the middle, and has its seat', async () => {
    await playOn(phones);
    const seat = seatOf(theo);
    await theo.page.reload();
    await expect(theo.page.getByText('Theo').first()).toBeVisible();
    await expect.poll(() => view!.room.players[seat]?.awaySinceMs ?? 'here').toBe('here');
    expect(seatOf(theo)).toBe(seat);
    // Three walk over the edge, who stays wins
    while (view?.room.phase === 'play') {
      for (const phone of [theo, ines, jo]) {
        const state = seen.get('hill')?.state as
          | { pieces: { seat: number; position: { x: number; y: number }; outAt?: number }[] }
          | undefined;
        const piece = state?.pieces.find((one) => one.seat === seatOf(phone));
        if (!piece || piece.outAt !== undefined) continue;
        const { x, y } = piece.position;
        const far = Math.hypot(x, y) || 1;
        await phone.steer(x / far, y / far);
      }
      await screen.page.waitForTimeout(50);
    }
    for (const phone of [theo, ines, jo]) await phone.release();
    await screen.expectPhase('podium');
    expect(view!.room.results[1]!.places[0]).toEqual([seatOf(mara)]);
  });

  let lin: PartyPhonePage | undefined;
  await test.step('one leaves, one comes late and waits', async () => {
    await jo.page.close();
    await playOn([mara, theo, ines]);
    lin = new PartyPhonePage((await room.withPhone()).page, 'Lin');
    await lin.join();
    await expect
      .poll(() => view!.room.players.find(({ name }) => name === 'Lin')?.isWaiting)
      .toBe(true);
  });

  await test.step('Marble Dash, faster while it runs: everybody feels it', async () => {
    await screen.page.keyboard.press('h');
    const speed = screen.page.getByRole('slider').first();
    await speed.fill('2');
    await screen.page.keyboard.press('Escape');
    await playOut('race', [mara, theo, ines]);
    expect(view!.room.results[2]!.game).toBe('race');
  });

  await test.step('Tilt Quiz, with who came late', async () => {
    const all = [mara, theo, ines, lin!];
    await playOn(all);
    await playOut('quiz', all);
    const { answerers } = seen.get('quiz')!.state as { answerers: { seat: Seat; score: number }[] };
    for (const phone of all) {
      expect(answerers.find(({ seat }) => seat === seatOf(phone))!.score).toBeGreaterThan(0);
    }
  });

  await test.step('the table is the sum of all rounds, and the tournament ends', async () => {
    const { players, results } = view!.room;
    for (const { seat, points } of players) {
      expect(points).toBe(results.reduce((sum, one) => sum + (one.points[seat] ?? 0), 0));
    }
    const best = [...players].sort((a, b) => b.points - a.points || a.seat - b.seat);
    // After the replay of the decisive moment
    await expect.poll(() => screen.table()).toEqual(best.map(({ name }) => name));
    // The podium ends by itself
    await screen.expectPhase('end');
    await expect(screen.page.getByRole('heading', { level: 1 })).toHaveText(/tournament$/);
  });
});
