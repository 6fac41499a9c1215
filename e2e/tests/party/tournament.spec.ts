import { GAMES, type DuelState, type Game, type GameId, type Seat } from '@ubii/party/sim';
import { stateTopic, type RoomView } from '@ubii/party/net';
import type { RoundState } from '@ubii/party/modules';
import { expect, test } from '../../fixtures/test.ts';
import { PartyPhonePage, PartyScreenPage } from '../../pages/party-pages.ts';

/** The first two are taken out, the last one is taken in: King of the Hill and Quick Draw take the least time. */
const CHOICE = ['Photo Hunt', 'Marble Dash', 'Quick Draw'];

interface Standing {
  readonly seat: Seat;
  readonly position: { readonly x: number; readonly y: number };
  readonly outAt?: number;
}

test('four phones play a tournament by touch: one reloads, one leaves, one comes late', async ({
  room,
}) => {
  test.setTimeout(600_000);
  const screen = new PartyScreenPage((await room.atDesk('Big screen')).page);
  await screen.open();
  const join = async (name: string): Promise<PartyPhonePage> => {
    const phone = new PartyPhonePage((await room.withPhone()).page, name);
    await phone.join();
    return phone;
  };
  const [mara, theo, ines, jo] = await Promise.all([
    join('Mara'),
    join('Theo'),
    join('Ines'),
    join('Jo'),
  ]);
  await screen.expectPlayers(4);

  // State that the players see: seats, the newest state of each game, and who pressed in the duel.
  const eyes = await room.program('eyes');
  const seen = new Map<GameId, RoundState>();
  const drew = new Set<Seat>();
  for (const game of Object.keys(GAMES) as GameId[]) {
    const states = eyes.subscribe(stateTopic(game), { format: 'string' });
    states.onRecord(({ value }) => {
      const state = JSON.parse(value) as RoundState;
      seen.set(game, state);
      if (game !== 'duel') return;
      const { presses } = (state.state as DuelState).bout;
      for (const seat of Object.keys(presses)) drew.add(Number(seat));
    });
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
  /** Players do in Quick Draw what its own bot would, with their thumbs, until the round is over. */
  const playOut = async (who: readonly PartyPhonePage[]): Promise<void> => {
    const rules = GAMES.duel as unknown as Game<unknown>;
    while (view?.room.phase === 'play') {
      const state = seen.get('duel');
      for (const phone of who) {
        if (!state || state.id !== view.round?.id) continue;
        const seat = seatOf(phone);
        const hasPressed = seat in (state.state as DuelState).bout.presses;
        if (!hasPressed && rules.bot(state.state, seat).isPressed) await phone.press();
      }
      await screen.page.waitForTimeout(30);
    }
    await screen.expectPhase('podium');
  };

  /** Moves a slider of the game in the host's menu. */
  const setSlider = async (value: string): Promise<void> => {
    await screen.page.keyboard.press('h');
    await screen.page.getByRole('slider').first().fill(value);
    await screen.page.keyboard.press('Escape');
  };

  for (const game of CHOICE) await screen.page.getByRole('button', { name: game }).click();
  await screen.start();

  const lin =
    await test.step('King of the Hill: one comes late and waits, a phone reloads in the middle, and has its seat', async () => {
      const walkers = [theo, ines, jo];
      await playOn([mara, ...walkers]);
      const late = await join('Lin');
      await expect
        .poll(() => view!.room.players.find(({ name }) => name === 'Lin')?.isWaiting)
        .toBe(true);
      const seat = seatOf(theo);
      await theo.page.reload();
      await expect(theo.page.getByText('Theo').first()).toBeVisible();
      await expect.poll(() => view!.room.players[seat]?.awaySinceMs ?? 'here').toBe('here');
      expect(seatOf(theo)).toBe(seat);
      // Three walk over the edge, who stays wins
      while (view?.room.phase === 'play') {
        for (const phone of walkers) {
          const state = seen.get('hill')?.state as { pieces: readonly Standing[] } | undefined;
          const piece = state?.pieces.find((one) => one.seat === seatOf(phone));
          if (!piece || piece.outAt !== undefined) continue;
          const { x, y } = piece.position;
          const far = Math.hypot(x, y) || 1;
          await phone.steer(x / far, y / far);
        }
        await screen.page.waitForTimeout(50);
      }
      for (const phone of walkers) await phone.release();
      await screen.expectPhase('podium');
      const { game, places } = view!.room.results[0]!;
      expect(game).toBe('hill');
      expect(places[0]).toEqual([seatOf(mara)]);
      expect(places.flat().sort()).toEqual([mara, ...walkers].map(seatOf).sort());
      return late;
    });

  const stayed = [mara, theo, ines, lin];
  await test.step('Quick Draw with short waits: one has left, who came late plays', async () => {
    await jo.page.close();
    // Whoever has left is waited for until that is noticed; in the explanation, the host is first.
    const endPodium = async (): Promise<string> => {
      for (const phone of stayed) if (view!.room.phase === 'podium') await phone.ready();
      return view!.room.phase;
    };
    await expect.poll(endPodium).toBe('explanation');
    await setSlider('0');
    await playOn(stayed);
    await playOut(stayed);
    expect(view!.room.results[1]!.game).toBe('duel');
    expect([...drew].sort()).toEqual(stayed.map(seatOf).sort());
  });

  await test.step('the table is the sum of all rounds, and the tournament ends', async () => {
    const { players, results } = view!.room;
    for (const { seat, points } of players) {
      expect(points).toBe(results.reduce((sum, one) => sum + (one.points[seat] ?? 0), 0));
    }
    const best = [...players].sort((a, b) => b.points - a.points || a.seat - b.seat);
    // After the replay of the decisive moment
    await expect.poll(() => screen.table()).toEqual(best.map(({ name }) => name));
    for (const phone of stayed) await phone.ready();
    await screen.expectPhase('end');
    await expect(screen.page.getByRole('heading', { level: 1 })).toHaveText(/tournament$/);
  });
});
