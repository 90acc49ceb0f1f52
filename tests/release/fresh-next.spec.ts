// Does the packed tarball work in a fresh Next project (App Router)? A server component renders the components, and a
// client component hears events of markup that came from the server. Installs from the registry, so it is slow:
// @release.

import { allReady, expect, pixelAt, pixels, test } from '../support/test.js';
import { expectHeard, useFreshProject } from './fresh-project.js';

const layout = `
export default function Layout({ children }: { children: React.ReactNode }) {
  return <html lang="en"><head><link rel="icon" href="data:," /></head><body>{children}</body></html>;
}
`;

const page = `
import { PhongLight, PhongMesh, PhongViewer } from 'phong-viewer/react';
import { Watched } from './watched';

export default function Page() {
  return (
    <main>
      <PhongViewer id="still" alt="A sphere" geometry="sphere" ka={255} style={{ display: 'block', width: 300, height: 200 }}>
        <PhongLight name="off" active={false} diffuse={[0, 0, 255]} ambient={[0, 0, 255]} />
        <PhongLight name="on" ambient={[200, 100, 50]} diffuse={0} specular={[0, 0, 0]} />
      </PhongViewer>
      <Watched>
        <PhongLight diffuse={[90, 90, 90]} />
        <PhongMesh geometry="box" scale={[1, 2, 1]} />
      </Watched>
    </main>
  );
}
`;

const watched = `
'use client';
import { type ReactNode, useRef, useState } from 'react';
import { PhongViewer, type PhongViewerElement } from 'phong-viewer/react';

export function Watched({ children }: { readonly children: ReactNode }) {
  const viewer = useRef<PhongViewerElement>(null);
  const [moved, setMoved] = useState('');
  const [theta, setTheta] = useState(10);
  return (
    <>
      <PhongViewer
        ref={viewer} id="watched" theta={theta} orbit={false} className="picture"
        onCameraChange={({ detail }) => setMoved(detail.source + ' to ' + String(viewer.current?.camera.theta))}
      >
        {children}
      </PhongViewer>
      <button onClick={() => setTheta(25)}>turn</button>
      <output>{moved}</output>
    </>
  );
}
`;

test.describe('the packed tarball in a fresh Next project @release', () => {
  let origin = '';
  const types = ['typescript', '@types/react', '@types/node'];
  useFreshProject(['three', '@types/three', 'next@^16', 'react', 'react-dom', ...types], async (project) => {
    project.write('app/layout.tsx', layout);
    project.write('app/page.tsx', page);
    project.write('app/watched.tsx', watched);
    project.run('npx next build');
    origin = await project.serve('next/dist/bin/next', ['start', '--port', '0']);
  });

  test('sends every value as text, draws it, and dispatches events on hydrated markup', async ({ page }) => {
    const markup = await (await page.request.get(origin)).text();
    expect(markup).toContain('<phong-light name="off" active="false" diffuse="0 0 255" ambient="0 0 255">');
    expect(markup).toContain('<phong-mesh geometry="box" scale="1 2 1">');
    expect(markup).toContain(' orbit="false"');

    await page.goto(origin);
    await allReady(page);
    const picture = await pixels(page.locator('#still'), { width: 60, height: 40 });
    expect(pixelAt(picture, 30, 20)).toEqual([200, 100, 50, 255]);

    const watched = page.locator('#watched.picture');
    await expectHeard(page, watched);
    await page.getByText('turn').click();
    await expect(page.locator('output')).toHaveText('script to 25');
    await expect(watched).toHaveAttribute('theta', '25');
  });
});
