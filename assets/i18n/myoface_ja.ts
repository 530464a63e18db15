<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="ja" sourcelanguage="en">
<context>
    <name>ActionSearch</name>
    <message>
        <source>Find an action</source>
        <translation>操作を探す</translation>
    </message>
    <message>
        <source>What do you want to do?</source>
        <translation>何をしますか？</translation>
    </message>
</context>
<context>
    <name>BackgroundJob</name>
    <message>
        <source>There is not enough memory for this.</source>
        <translation>メモリーが足りません。</translation>
    </message>
</context>
<context>
    <name>Callipers</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 mm, along the skin %2 mm</source>
        <translation>%1 mm、皮膚に沿って %2 mm</translation>
    </message>
    <message>
        <source>%1°</source>
        <translation>%1°</translation>
    </message>
    <message>
        <source>A third click measures the angle at this point; Esc ends.</source>
        <translation>もう一度クリックするとこの点の角度を測ります。Esc で終わります。</translation>
    </message>
    <message>
        <source>Another click begins anew; Esc ends.</source>
        <translation>次のクリックで測り直します。Esc で終わります。</translation>
    </message>
    <message>
        <source>Click the other end of the distance.</source>
        <translation>距離のもう一方の端をクリックしてください。</translation>
    </message>
</context>
<context>
    <name>CliExport</name>
    <message>
        <source>%1 does not start: it writes the report and belongs beside this program.</source>
        <translation>%1 が起動しません。報告書を書くプログラムで、このプログラムと同じ所に必要です。</translation>
    </message>
    <message>
        <source>%1 was not written.</source>
        <translation>%1 は書き出されませんでした。</translation>
    </message>
</context>
<context>
    <name>ComparePanel</name>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>Against the actual result</source>
        <translation>実際の結果との比較</translation>
    </message>
    <message>
        <source>Before and after</source>
        <translation>術前・術後</translation>
    </message>
    <message>
        <source>Both turn together</source>
        <translation>左右が一緒に回ります</translation>
    </message>
    <message>
        <source>Change</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>Compare with</source>
        <translation>比較の相手</translation>
    </message>
    <message>
        <source>Double click shows a variant, F2 renames it</source>
        <translation>ダブルクリックで案を表示、F2 で名前を変更します</translation>
    </message>
    <message>
        <source>Drag the line across the face</source>
        <translation>線を顔の上でドラッグします</translation>
    </message>
    <message>
        <source>From before (left) to now (right)</source>
        <translation>左が前、右が現在です</translation>
    </message>
    <message>
        <source>Ghost</source>
        <translation>透かし</translation>
    </message>
    <message>
        <source>Hold the space bar to see the state before</source>
        <translation>スペースキーを押している間、前の状態を表示します</translation>
    </message>
    <message>
        <source>Keep this one</source>
        <translation>この案を残す</translation>
    </message>
    <message>
        <source>Keeps the face as it is now as variant A, B, C …</source>
        <translation>今の顔を案 A、B、C … として残します</translation>
    </message>
    <message>
        <source>Lays a scan taken after the operation on the face, by forehead and nasal root, and measures how far the plan was off</source>
        <translation>術後に撮ったスキャンを額と鼻根で顔に重ね、計画とのずれを測ります</translation>
    </message>
    <message>
        <source>Map of the change</source>
        <translation>変化の色分け</translation>
    </message>
    <message>
        <source>Map of the sides</source>
        <translation>左右差のマップ</translation>
    </message>
    <message>
        <source>Millimetres of the last colour</source>
        <translation>最後の色に当たる mm</translation>
    </message>
    <message>
        <source>Only the face as it is now</source>
        <translation>今の顔だけ</translation>
    </message>
    <message>
        <source>Open a scan of afterwards…</source>
        <translation>術後のスキャンを開く…</translation>
    </message>
    <message>
        <source>Orange where a side stands out over the mirror image of the other, about this patient's own midplane, blue where it lies behind it</source>
        <translation>この患者自身の正中面で鏡映した反対側より出ている所はオレンジ、引っ込んでいる所は青</translation>
    </message>
    <message>
        <source>Orange where the skin has come out, blue where it has gone in</source>
        <translation>橙は皮膚が出た所、青は引っ込んだ所</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Share of the change that is shown</source>
        <translation>表示する変化の割合</translation>
    </message>
    <message>
        <source>Show</source>
        <translation>表示</translation>
    </message>
    <message>
        <source>Side by side</source>
        <translation>左右に並べる</translation>
    </message>
    <message>
        <source>The state before, translucent over the face</source>
        <translation>前の状態を半透明で顔に重ねます</translation>
    </message>
    <message>
        <source>Variants of the plan</source>
        <translation>計画の案</translation>
    </message>
    <message>
        <source>Wipe</source>
        <translation>ワイプ</translation>
    </message>
    <message>
        <source>With</source>
        <translation>相手</translation>
    </message>
    <message>
        <source>the scan as it came</source>
        <translation>元のスキャン</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>案 %1</translation>
    </message>
</context>
<context>
    <name>Comparison</name>
    <message>
        <source>&amp;lt; 2 mm</source>
        <translation>&amp;lt; 2 mm</translation>
    </message>
    <message>
        <source>90 %</source>
        <translation>90 %</translation>
    </message>
    <message>
        <source>&lt;p&gt;%1, laid on forehead and nasal root (%2 mm left)&lt;/p&gt;</source>
        <translation>&lt;p&gt;%1：額と鼻根で重ねました（残差 %2 mm）&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Faces (*.obj *.ply *.stl *.glb *.gltf *.myoface);;All files (*)</source>
        <translation>顔 (*.obj *.ply *.stl *.glb *.gltf *.myoface);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Kept as variant %1.</source>
        <translation>案 %1 として残しました。</translation>
    </message>
    <message>
        <source>Laying %1 on the face…</source>
        <translation>%1 を顔に重ねています…</translation>
    </message>
    <message>
        <source>Open a scan of afterwards</source>
        <translation>術後のスキャンを開く</translation>
    </message>
    <message>
        <source>before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>keep variant %1</source>
        <translation>案 %1 を残す</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>out +%1 mm</source>
        <translation>外へ +%1 mm</translation>
    </message>
    <message>
        <source>remove variant</source>
        <translation>案を削除</translation>
    </message>
    <message>
        <source>rename variant</source>
        <translation>案の名前を変更</translation>
    </message>
    <message>
        <source>stands out +%1 mm</source>
        <translation>突出 +%1 mm</translation>
    </message>
    <message>
        <source>untreated</source>
        <translation>治療前の強さ</translation>
    </message>
    <message>
        <source>variant %1</source>
        <translation>案 %1</translation>
    </message>
    <message>
        <source>−%1 mm behind</source>
        <translation>−%1 mm 後退</translation>
    </message>
    <message>
        <source>−%1 mm in</source>
        <translation>内へ −%1 mm</translation>
    </message>
</context>
<context>
    <name>FaceFiles</name>
    <message>
        <source>%1 was changed by another program or window since it was opened here.</source>
        <translation>%1 は、ここで開いた後に別のプログラムかウィンドウで変更されています。</translation>
    </message>
    <message>
        <source>A film or pictures all around the head</source>
        <translation>頭部を一周する動画または画像</translation>
    </message>
    <message>
        <source>A film or pictures from rest to the face as it is</source>
        <translation>安静から今の顔までの動画または画像</translation>
    </message>
    <message>
        <source>Cancelled; nothing was written.</source>
        <translation>中止しました。何も書き出していません。</translation>
    </message>
    <message>
        <source>Drawing the film</source>
        <translation>動画を描画中</translation>
    </message>
    <message>
        <source>Export a picture</source>
        <translation>画像を書き出す</translation>
    </message>
    <message>
        <source>Export a report</source>
        <translation>報告書を書き出す</translation>
    </message>
    <message>
        <source>Export the face as it is shown</source>
        <translation>表示中の顔を書き出す</translation>
    </message>
    <message>
        <source>Faces (*.obj *.ply *.stl *.glb *.gltf *.myoface);;All files (*)</source>
        <translation>顔 (*.obj *.ply *.stl *.glb *.gltf *.myoface);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>GIF (*.gif);;Film (*.mp4);;Folder of PNG pictures (*)</source>
        <translation>GIF (*.gif);;動画 (*.mp4);;PNG 画像のフォルダー (*)</translation>
    </message>
    <message>
        <source>Landmarks (*.json);;All files (*)</source>
        <translation>特徴点 (*.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>Myoface</source>
        <translation>Myoface</translation>
    </message>
    <message>
        <source>Myoface case (*.myoface)</source>
        <translation>Myoface の症例 (*.myoface)</translation>
    </message>
    <message>
        <source>None yet</source>
        <translation>まだありません</translation>
    </message>
    <message>
        <source>OBJ (*.obj);;PLY (*.ply);;GLB (*.glb);;STL (*.stl)</source>
        <translation>OBJ (*.obj);;PLY (*.ply);;GLB (*.glb);;STL (*.stl)</translation>
    </message>
    <message>
        <source>Open a face</source>
        <translation>顔を開く</translation>
    </message>
    <message>
        <source>Open landmarks</source>
        <translation>特徴点を開く</translation>
    </message>
    <message>
        <source>Overwrite</source>
        <translation>上書き</translation>
    </message>
    <message>
        <source>PDF (*.pdf)</source>
        <translation>PDF (*.pdf)</translation>
    </message>
    <message>
        <source>PNG (*.png)</source>
        <translation>PNG (*.png)</translation>
    </message>
    <message>
        <source>STL (*.stl)</source>
        <translation>STL (*.stl)</translation>
    </message>
    <message>
        <source>Save as…</source>
        <translation>別名で保存…</translation>
    </message>
    <message>
        <source>Save the case</source>
        <translation>症例を保存</translation>
    </message>
    <message>
        <source>Saved: %1</source>
        <translation>保存しました：%1</translation>
    </message>
    <message>
        <source>Saving</source>
        <translation>保存中</translation>
    </message>
    <message>
        <source>Something is being written already; wait for it or cancel it.</source>
        <translation>ほかの書き出しが進行中です。終わるまで待つか、中止してください。</translation>
    </message>
    <message>
        <source>Writing the face</source>
        <translation>顔を書き出し中</translation>
    </message>
    <message>
        <source>Writing the picture</source>
        <translation>画像を書き出し中</translation>
    </message>
    <message>
        <source>Writing the report</source>
        <translation>レポートを書き出し中</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました：%1</translation>
    </message>
</context>
<context>
    <name>FaceView</name>
    <message>
        <source>%1 as a ghost over now</source>
        <translation>%1の透かしを現在に重ねています</translation>
    </message>
    <message>
        <source>10 mm</source>
        <translation>10 mm</translation>
    </message>
    <message>
        <source>Face</source>
        <translation>顔</translation>
    </message>
    <message>
        <source>from the side</source>
        <translation>横から</translation>
    </message>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
</context>
<context>
    <name>LandmarkEditor</name>
    <message>
        <source>%1 from the other side</source>
        <translation>%1 を反対側から</translation>
    </message>
    <message>
        <source>accept %1</source>
        <translation>%1 を確定</translation>
    </message>
    <message>
        <source>depth of the soft tissue</source>
        <translation>軟部組織の厚さ</translation>
    </message>
    <message>
        <source>find landmarks</source>
        <translation>特徴点を探す</translation>
    </message>
    <message>
        <source>move %1</source>
        <translation>%1 を動かす</translation>
    </message>
</context>
<context>
    <name>LandmarkGuide</name>
    <message>
        <source>Back</source>
        <translation>戻る</translation>
    </message>
    <message>
        <source>Point %1 of %2: click &lt;b&gt;%3&lt;/b&gt;</source>
        <translation>点 %1 / %2：&lt;b&gt;%3&lt;/b&gt; をクリック</translation>
    </message>
    <message>
        <source>the base of the nose, where it meets the upper lip</source>
        <translation>鼻の付け根（上唇に移る所）</translation>
    </message>
    <message>
        <source>the foremost point of the chin</source>
        <translation>オトガイの最前点</translation>
    </message>
    <message>
        <source>the inner corner of the patient's left eye</source>
        <translation>患者の左の目頭</translation>
    </message>
    <message>
        <source>the inner corner of the patient's right eye</source>
        <translation>患者の右の目頭</translation>
    </message>
    <message>
        <source>the lower lip's border in the middle</source>
        <translation>下唇の縁の中央</translation>
    </message>
    <message>
        <source>the middle of the line between the lips</source>
        <translation>唇の合わせ目の中央</translation>
    </message>
    <message>
        <source>the notch in front of the patient's left ear</source>
        <translation>患者の左耳の前の切れ込み</translation>
    </message>
    <message>
        <source>the notch in front of the patient's right ear</source>
        <translation>患者の右耳の前の切れ込み</translation>
    </message>
    <message>
        <source>the outer corner of the patient's left eye</source>
        <translation>患者の左の目尻</translation>
    </message>
    <message>
        <source>the outer corner of the patient's right eye</source>
        <translation>患者の右の目尻</translation>
    </message>
    <message>
        <source>the patient's left mouth corner</source>
        <translation>患者の左の口角</translation>
    </message>
    <message>
        <source>the patient's right mouth corner</source>
        <translation>患者の右の口角</translation>
    </message>
    <message>
        <source>the tip of the nose</source>
        <translation>鼻の先</translation>
    </message>
    <message>
        <source>the upper lip's border in the middle</source>
        <translation>上唇の縁の中央</translation>
    </message>
</context>
<context>
    <name>LandmarkPanel</name>
    <message>
        <source>A net of the built-in head as it was fitted; where it is red it lies off the scan</source>
        <translation>当てはめた内蔵の頭を網で示します。赤い所はスキャンから離れています</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>確定</translation>
    </message>
    <message>
        <source>Choose a landmark to see what it is.</source>
        <translation>特徴点を選ぶと説明が出ます。</translation>
    </message>
    <message>
        <source>Drag a marker on the skin: the fit follows. Markers are green where the program is sure, red where it is not, blue once you have placed them.</source>
        <translation>皮膚の上の印をドラッグすると、当てはめが追従します。確かな点は緑、不確かな点は赤、手で置いた点は青です。</translation>
    </message>
    <message>
        <source>Find again</source>
        <translation>探し直す</translation>
    </message>
    <message>
        <source>Finds all landmarks by the shape of the face</source>
        <translation>顔の形からすべての特徴点を探します</translation>
    </message>
    <message>
        <source>From other side</source>
        <translation>反対側から</translation>
    </message>
    <message>
        <source>How much soft tissue lies over the bone: the scan does not show it. Mean values of the forensic tables, or 15 % (forehead) to 35 % (cheeks) beside them.</source>
        <translation>骨の上の軟部組織の厚さです。スキャンからは分かりません。法医学の表の平均値、またはその 15 %（額）から 35 %（頬）増減した値です。</translation>
    </message>
    <message>
        <source>Landmark</source>
        <translation>特徴点</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>特徴点</translation>
    </message>
    <message>
        <source>Next to check</source>
        <translation>次に確認</translation>
    </message>
    <message>
        <source>Places it at the mirror image of the other side's, about this patient's own midplane</source>
        <translation>反対側の点を、この患者の正中面で折り返した所に置きます</translation>
    </message>
    <message>
        <source>Searching …</source>
        <translation>探しています…</translation>
    </message>
    <message>
        <source>Show and move landmarks</source>
        <translation>特徴点を表示して動かす</translation>
    </message>
    <message>
        <source>Show the fitted head</source>
        <translation>当てはめた頭を表示</translation>
    </message>
    <message>
        <source>Soft tissue</source>
        <translation>軟部組織</translation>
    </message>
    <message>
        <source>The fitted head lies %1 mm off the scan in the middle, %2 mm at 95 %.</source>
        <translation>当てはめた頭とスキャンの距離：中央値 %1 mm、95 % で %2 mm</translation>
    </message>
    <message>
        <source>The landmark that the program is least sure of</source>
        <translation>最も不確かな特徴点</translation>
    </message>
    <message>
        <source>This one is right as it is</source>
        <translation>この点は今のままで正しい</translation>
    </message>
    <message>
        <source>checked</source>
        <translation>確認済み</translation>
    </message>
    <message>
        <source>heavy</source>
        <translation>厚い</translation>
    </message>
    <message>
        <source>mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>thin</source>
        <translation>薄い</translation>
    </message>
    <message>
        <source>± mm</source>
        <translation>± mm</translation>
    </message>
</context>
<context>
    <name>LayerPanel</name>
    <message>
        <source>All</source>
        <translation>すべて</translation>
    </message>
    <message>
        <source>Bone</source>
        <translation>骨</translation>
    </message>
    <message>
        <source>Cut-away</source>
        <translation>切り取り</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>筋</translation>
    </message>
    <message>
        <source>Opacity</source>
        <translation>不透明度</translation>
    </message>
    <message>
        <source>Opacity of %1</source>
        <translation>%1の不透明度</translation>
    </message>
    <message>
        <source>Skin</source>
        <translation>皮膚</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>ばね</translation>
    </message>
    <message>
        <source>Takes the skin away from the patient's left side on</source>
        <translation>患者の左側から皮膚を取り除きます</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>%1[*] — Myoface</source>
        <translation>%1[*] — Myoface</translation>
    </message>
    <message>
        <source>&amp;About Myoface</source>
        <translation>Myoface について(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Cameras linked</source>
        <translation>視点を連動(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Clinical light</source>
        <translation>臨床写真の光(&amp;C)</translation>
    </message>
    <message>
        <source>&amp;Edit</source>
        <translation>編集(&amp;E)</translation>
    </message>
    <message>
        <source>&amp;Export face…</source>
        <translation>顔を書き出す(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>ファイル(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Find an action…</source>
        <translation>操作を探す(&amp;F)…</translation>
    </message>
    <message>
        <source>&amp;Four: front, profile, three-quarter, from below</source>
        <translation>4 画面：正面・側面・斜め・下から(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Front</source>
        <translation>正面(&amp;F)</translation>
    </message>
    <message>
        <source>&amp;Ghost</source>
        <translation>透かし(&amp;G)</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>ヘルプ(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Keep as variant</source>
        <translation>案として残す(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Keys and mouse</source>
        <translation>キーとマウス(&amp;K)</translation>
    </message>
    <message>
        <source>&amp;Manual</source>
        <translation>説明書(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Map of the change</source>
        <translation>変化の色分け(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Motion of tissue</source>
        <translation>組織の動き(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Next: one, two, four</source>
        <translation>次へ：1・2・4 画面(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Now alone</source>
        <translation>今の顔だけ(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;One view</source>
        <translation>1 画面(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>開く(&amp;O)…</translation>
    </message>
    <message>
        <source>&amp;Orthographic</source>
        <translation>平行投影(&amp;O)</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>パネル(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Place landmarks by hand</source>
        <translation>特徴点を手で置く(&amp;P)</translation>
    </message>
    <message>
        <source>&amp;Preferences…</source>
        <translation>設定(&amp;P)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>終了(&amp;Q)</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>やり直す(&amp;R)</translation>
    </message>
    <message>
        <source>&amp;Save case</source>
        <translation>症例を保存(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Side by side</source>
        <translation>左右に並べる(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Swings, as fast as in life</source>
        <translation>揺れる：実際の速さ(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Two: front and profile</source>
        <translation>2 画面：正面と側面(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>元に戻す(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>表示(&amp;V)</translation>
    </message>
    <message>
        <source>&amp;Wipe</source>
        <translation>ワイプ(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Wireframe</source>
        <translation>三角形の網(&amp;W)</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Everywhere&lt;/h3&gt;</source>
        <translation>&lt;h3&gt;どこでも&lt;/h3&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Mouse&lt;/h3&gt;&lt;table cellspacing=4&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left drag on skin&lt;/b&gt;&lt;/td&gt;&lt;td&gt;what the tool says&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Left drag beside the face, Alt + left, middle&lt;/b&gt;&lt;/td&gt;&lt;td&gt;turn&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Right drag, Shift + middle&lt;/b&gt;&lt;/td&gt;&lt;td&gt;pan&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Wheel&lt;/b&gt;&lt;/td&gt;&lt;td&gt;zoom towards the cursor&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Double click on a slider&lt;/b&gt;&lt;/td&gt;&lt;td&gt;muscle at rest&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;&lt;h3&gt;Keys on the face&lt;/h3&gt;&lt;table cellspacing=4&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;radius of the grip, then move the mouse&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;X&lt;/b&gt;&lt;/td&gt;&lt;td&gt;same on the other side&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Arrows&lt;/b&gt;&lt;/td&gt;&lt;td&gt;0.1 mm, with Shift 1 mm&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Space&lt;/b&gt;&lt;/td&gt;&lt;td&gt;hold to see the state before&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Home&lt;/b&gt;&lt;/td&gt;&lt;td&gt;whole head&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;give up the gesture&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</source>
        <translation>&lt;h3&gt;マウス&lt;/h3&gt;&lt;table cellspacing=4&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;皮膚の上で左ドラッグ&lt;/b&gt;&lt;/td&gt;&lt;td&gt;選んだ道具の働き&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;顔の外で左ドラッグ、Alt + 左、中ボタン&lt;/b&gt;&lt;/td&gt;&lt;td&gt;回す&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;右ドラッグ、Shift + 中ボタン&lt;/b&gt;&lt;/td&gt;&lt;td&gt;ずらす&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;ホイール&lt;/b&gt;&lt;/td&gt;&lt;td&gt;カーソルの所を拡大・縮小&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;スライダーをダブルクリック&lt;/b&gt;&lt;/td&gt;&lt;td&gt;筋を安静に戻す&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;&lt;h3&gt;顔の上のキー&lt;/h3&gt;&lt;table cellspacing=4&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;F&lt;/b&gt;&lt;/td&gt;&lt;td&gt;つかむ半径（続けてマウスを動かす）&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;X&lt;/b&gt;&lt;/td&gt;&lt;td&gt;反対側も同じに&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;矢印&lt;/b&gt;&lt;/td&gt;&lt;td&gt;0.1 mm、Shift で 1 mm&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;スペース&lt;/b&gt;&lt;/td&gt;&lt;td&gt;押している間、前の状態&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Home&lt;/b&gt;&lt;/td&gt;&lt;td&gt;頭全体&lt;/td&gt;&lt;/tr&gt;&lt;tr&gt;&lt;td&gt;&lt;b&gt;Esc&lt;/b&gt;&lt;/td&gt;&lt;td&gt;操作を取りやめる&lt;/td&gt;&lt;/tr&gt;&lt;/table&gt;</translation>
    </message>
    <message>
        <source>&lt;h3&gt;Myoface %1&lt;/h3&gt;&lt;p&gt;Facial surgery consultation simulator on a muscle-spring model.&lt;/p&gt;&lt;p&gt;A planning and communication aid, not a medical device: what it shows is an estimate, not a promise of a result.&lt;/p&gt;&lt;p&gt;Apache License 2.0. Uses Qt (LGPL 3), Eigen (MPL 2), assimp, libzip, GLFW (BSD and zlib), libepoxy, nlohmann-json, CLI11 and nanoflann (MIT and BSD).&lt;/p&gt;</source>
        <translation>&lt;h3&gt;Myoface %1&lt;/h3&gt;&lt;p&gt;筋・ばねモデルによる顔面手術の説明用シミュレーター。&lt;/p&gt;&lt;p&gt;計画と説明のための補助であり、医療機器ではありません。表示は推定であり、結果を約束するものではありません。&lt;/p&gt;&lt;p&gt;Apache License 2.0。Qt (LGPL 3)、Eigen (MPL 2)、assimp、libzip、GLFW (BSD・zlib)、libepoxy、nlohmann-json、CLI11、nanoflann (MIT・BSD) を使用しています。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>&lt;p&gt;&lt;b&gt;Drag the skin&lt;/b&gt; to shape it. Beside the face, the left button turns the head; the wheel zooms.&lt;/p&gt;&lt;p&gt;&lt;b&gt;The steps above&lt;/b&gt; lead from the scan to the report.&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl+K&lt;/b&gt; finds everything by name, &lt;b&gt;F1&lt;/b&gt; shows all keys.&lt;/p&gt;</source>
        <translation>&lt;p&gt;&lt;b&gt;皮膚をドラッグ&lt;/b&gt;すると形が変わります。顔の外の左ドラッグで頭が回り、ホイールで拡大します。&lt;/p&gt;&lt;p&gt;&lt;b&gt;上の段階&lt;/b&gt;がスキャンから報告書まで導きます。&lt;/p&gt;&lt;p&gt;&lt;b&gt;Ctrl+K&lt;/b&gt; で名前から何でも探せます。&lt;b&gt;F1&lt;/b&gt; ですべてのキーを表示します。&lt;/p&gt;</translation>
    </message>
    <message>
        <source>A click adds the volume that the Shape panel says, under the skin</source>
        <translation>クリックした所の皮下に、「形」パネルの体積を加えます</translation>
    </message>
    <message>
        <source>A click cuts the face level through the place; a line drawn across the face cuts along it</source>
        <translation>クリックした点を通る水平断面。顔を横切る線を引くと、その線に沿って切ります</translation>
    </message>
    <message>
        <source>A planning and communication aid, not a medical device</source>
        <translation>計画と説明のための補助であり、医療機器ではありません</translation>
    </message>
    <message>
        <source>About Myoface</source>
        <translation>Myoface について</translation>
    </message>
    <message>
        <source>All muscles at &amp;rest</source>
        <translation>すべての筋を安静に(&amp;R)</translation>
    </message>
    <message>
        <source>Apply plan…</source>
        <translation>計画を適用…</translation>
    </message>
    <message>
        <source>Back to the scan: muscles at rest, shape as it came</source>
        <translation>元のスキャンに戻します：筋は安静、形は元のまま</translation>
    </message>
    <message>
        <source>Before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Before and &amp;after</source>
        <translation>術前・術後(&amp;A)</translation>
    </message>
    <message>
        <source>Before and after, variants</source>
        <translation>術前・術後と計画の案</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>較正</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>キャンセル</translation>
    </message>
    <message>
        <source>Change unit or axes</source>
        <translation>単位または軸を変える</translation>
    </message>
    <message>
        <source>Compare</source>
        <translation>比較</translation>
    </message>
    <message>
        <source>Constraint priority: a stress pulls at the skin, tissue holds it back, on release it springs back</source>
        <translation>制約優先：力が皮膚を引き、組織が引き留め、放すと元に戻ります</translation>
    </message>
    <message>
        <source>Discard</source>
        <translation>破棄</translation>
    </message>
    <message>
        <source>Don't save</source>
        <translation>保存しない</translation>
    </message>
    <message>
        <source>Even light from the front, as in clinical photographs</source>
        <translation>臨床写真のような正面からの均一な光</translation>
    </message>
    <message>
        <source>Everything by its name</source>
        <translation>名前で何でも探す</translation>
    </message>
    <message>
        <source>Export &amp;report…</source>
        <translation>報告書を書き出す(&amp;R)…</translation>
    </message>
    <message>
        <source>Export p&amp;icture…</source>
        <translation>画像を書き出す(&amp;I)…</translation>
    </message>
    <message>
        <source>Export plan…</source>
        <translation>計画を書き出す…</translation>
    </message>
    <message>
        <source>Export the e&amp;xpression moving…</source>
        <translation>表情の動きを書き出す(&amp;X)…</translation>
    </message>
    <message>
        <source>Export the head &amp;turning…</source>
        <translation>頭部の回転を書き出す(&amp;T)…</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>表情</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>全画面(&amp;U)</translation>
    </message>
    <message>
        <source>Feel</source>
        <translation>触れる</translation>
    </message>
    <message>
        <source>Find</source>
        <translation>検索</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>当てはめ</translation>
    </message>
    <message>
        <source>From &amp;above</source>
        <translation>上から(&amp;A)</translation>
    </message>
    <message>
        <source>From &amp;below</source>
        <translation>下から(&amp;B)</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>History</source>
        <translation>履歴</translation>
    </message>
    <message>
        <source>Keys and mouse</source>
        <translation>キーとマウス</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>特徴点</translation>
    </message>
    <message>
        <source>Landmarks, bone and muscles on the scan</source>
        <translation>スキャンの上の特徴点・骨・筋</translation>
    </message>
    <message>
        <source>Layers</source>
        <translation>層</translation>
    </message>
    <message>
        <source>Left drag paints skin that gestures leave alone</source>
        <translation>左ドラッグで、操作しても動かない皮膚を塗ります</translation>
    </message>
    <message>
        <source>Left drag turns the head</source>
        <translation>左ドラッグで頭を回します</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>計測</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>計測値</translation>
    </message>
    <message>
        <source>Mouse priority: the skin point follows the cursor, depth comes from the tissue, the shape stays</source>
        <translation>マウス優先：皮膚の点がカーソルに従い、奥行きは組織が決め、形は残ります</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>筋</translation>
    </message>
    <message>
        <source>Myoface</source>
        <translation>Myoface</translation>
    </message>
    <message>
        <source>Myoface ended while %1 had changes that were not saved (%2 steps, the last at %3).</source>
        <translation>%1 に保存していない変更（%2 段階、最後は %3）があるまま Myoface が終了しました。</translation>
    </message>
    <message>
        <source>Not now</source>
        <translation>後で</translation>
    </message>
    <message>
        <source>One view, two, four, and one again</source>
        <translation>1 画面、2 画面、4 画面、また 1 画面</translation>
    </message>
    <message>
        <source>Open &amp;landmarks…</source>
        <translation>特徴点を開く(&amp;L)…</translation>
    </message>
    <message>
        <source>Open &amp;recent</source>
        <translation>最近のファイル(&amp;R)</translation>
    </message>
    <message>
        <source>Open the &amp;built-in face</source>
        <translation>内蔵の顔を開く(&amp;B)</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>開いています</translation>
    </message>
    <message>
        <source>Opening was cancelled.</source>
        <translation>読み込みを中止しました。</translation>
    </message>
    <message>
        <source>Paper, pictures and files</source>
        <translation>紙・画像・ファイル</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>患者用</translation>
    </message>
    <message>
        <source>Patient &amp;view</source>
        <translation>患者用の表示(&amp;V)</translation>
    </message>
    <message>
        <source>Patient's &amp;left</source>
        <translation>患者の左(&amp;L)</translation>
    </message>
    <message>
        <source>Patient's &amp;right</source>
        <translation>患者の右(&amp;R)</translation>
    </message>
    <message>
        <source>Patient's left</source>
        <translation>患者の左</translation>
    </message>
    <message>
        <source>Patient's right</source>
        <translation>患者の右</translation>
    </message>
    <message>
        <source>Protect</source>
        <translation>保護</translation>
    </message>
    <message>
        <source>Protect the case…</source>
        <translation>症例を保護…</translation>
    </message>
    <message>
        <source>Recover</source>
        <translation>復元</translation>
    </message>
    <message>
        <source>Report</source>
        <translation>報告</translation>
    </message>
    <message>
        <source>Reset &amp;face</source>
        <translation>顔を元に戻す(&amp;F)</translation>
    </message>
    <message>
        <source>S&amp;teps</source>
        <translation>段階(&amp;T)</translation>
    </message>
    <message>
        <source>Save</source>
        <translation>保存</translation>
    </message>
    <message>
        <source>Save case &amp;as…</source>
        <translation>症例を別名で保存(&amp;A)…</translation>
    </message>
    <message>
        <source>Save the changes to this face?</source>
        <translation>この顔の変更を保存しますか？</translation>
    </message>
    <message>
        <source>Scan</source>
        <translation>スキャン</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>Several &amp;views</source>
        <translation>複数の画面(&amp;V)</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Shows the state before; the space bar does so while it is held</source>
        <translation>前の状態を表示します。スペースキーを押している間も表示します</translation>
    </message>
    <message>
        <source>Skin &amp;texture</source>
        <translation>皮膚のテクスチャ(&amp;T)</translation>
    </message>
    <message>
        <source>Steps</source>
        <translation>段階</translation>
    </message>
    <message>
        <source>Straight to &amp;rest</source>
        <translation>すぐに安静へ(&amp;R)</translation>
    </message>
    <message>
        <source>Swings, &amp;10 times slower</source>
        <translation>揺れる：10 倍ゆっくり(&amp;1)</translation>
    </message>
    <message>
        <source>Swings, &amp;4 times slower</source>
        <translation>揺れる：4 倍ゆっくり(&amp;4)</translation>
    </message>
    <message>
        <source>T&amp;urn slowly</source>
        <translation>ゆっくり回す(&amp;U)</translation>
    </message>
    <message>
        <source>The case will be saved with the passphrase.</source>
        <translation>症例はパスフレーズ付きで保存されます。</translation>
    </message>
    <message>
        <source>The case will be saved without a passphrase.</source>
        <translation>症例はパスフレーズなしで保存されます。</translation>
    </message>
    <message>
        <source>The colours of the scan, or plain skin that shows the shape</source>
        <translation>スキャンの色、または形がよく見える無地の皮膚</translation>
    </message>
    <message>
        <source>The face alone, full screen on the other screen</source>
        <translation>もう一つの画面に顔だけを全画面で表示します</translation>
    </message>
    <message>
        <source>The face is fitted anew, which ends the changes made to its shape and muscles. Go on?</source>
        <translation>顔を当てはめ直すため、形と筋の変更は失われます。続けますか？</translation>
    </message>
    <message>
        <source>The manual is %1, and no program that shows it was found.</source>
        <translation>説明書は %1 にありますが、表示するプログラムが見つかりません。</translation>
    </message>
    <message>
        <source>The triangles of the scan</source>
        <translation>スキャンの三角形</translation>
    </message>
    <message>
        <source>The two points are %1 mm apart as the scan is understood now.
Their true distance in mm (the iris is about 11.7 mm wide):</source>
        <translation>今の解釈では 2 点の間は %1 mm です。
実際の距離（mm、虹彩の幅は約 11.7 mm）：</translation>
    </message>
    <message>
        <source>This scan has no landmarks yet: click the points above, or open a landmark file.</source>
        <translation>このスキャンにはまだ特徴点がありません。上の点をクリックするか、特徴点のファイルを開いてください。</translation>
    </message>
    <message>
        <source>Three-quarter left</source>
        <translation>左斜め</translation>
    </message>
    <message>
        <source>Three-quarter right</source>
        <translation>右斜め</translation>
    </message>
    <message>
        <source>Tools</source>
        <translation>道具</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回す</translation>
    </message>
    <message>
        <source>Turning, moving and zooming one view does the same to all</source>
        <translation>1 つの画面の回転・移動・拡大が、すべての画面に伝わります</translation>
    </message>
    <message>
        <source>Turns the head until the mouse takes it</source>
        <translation>マウスで触れるまで頭を回します</translation>
    </message>
    <message>
        <source>Two clicks: distance straight and along the skin; a third: angle</source>
        <translation>2 回のクリックで直線距離と皮膚に沿った距離、3 回目で角度</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>What an operation changes</source>
        <translation>手術で変わるもの</translation>
    </message>
    <message>
        <source>What is in the file: unit, axes, size</source>
        <translation>ファイルの中身：単位・軸・大きさ</translation>
    </message>
    <message>
        <source>What muscles do</source>
        <translation>筋の働き</translation>
    </message>
    <message>
        <source>age of the skin</source>
        <translation>皮膚の年齢</translation>
    </message>
    <message>
        <source>at rest</source>
        <translation>安静</translation>
    </message>
    <message>
        <source>full strength</source>
        <translation>完全な筋力</translation>
    </message>
    <message>
        <source>largest move %1 mm · %2</source>
        <translation>最大移動 %1 mm · %2</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>移動中</translation>
    </message>
    <message>
        <source>muscles at rest</source>
        <translation>筋を安静に</translation>
    </message>
    <message>
        <source>reset</source>
        <translation>元に戻す</translation>
    </message>
    <message>
        <source>shape of the scan</source>
        <translation>スキャンの形</translation>
    </message>
    <message>
        <source>strength of %1</source>
        <translation>%1の筋力</translation>
    </message>
    <message>
        <source>the face as it was opened</source>
        <translation>開いたときの顔</translation>
    </message>
</context>
<context>
    <name>MeasurePanel</name>
    <message>
        <source>
norm %1 ± %2, z = %3
%4</source>
        <translation>
基準 %1 ± %2、z = %3
%4</translation>
    </message>
    <message>
        <source> years</source>
        <translation> 歳</translation>
    </message>
    <message>
        <source>Adults of European descent, 20 to 25 years; band: mean ± 2 standard deviations</source>
        <translation>ヨーロッパ系の成人、20～25 歳。帯：平均 ± 標準偏差の 2 倍</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>年齢</translation>
    </message>
    <message>
        <source>All measures as CSV or JSON</source>
        <translation>すべての計測値を CSV または JSON で</translation>
    </message>
    <message>
        <source>All measures as a table, for a spreadsheet</source>
        <translation>すべての計測値を表計算用の表として</translation>
    </message>
    <message>
        <source>CSV (*.csv);;JSON (*.json)</source>
        <translation>CSV (*.csv);;JSON (*.json)</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>コピー</translation>
    </message>
    <message>
        <source>Export the measures</source>
        <translation>計測値を書き出す</translation>
    </message>
    <message>
        <source>Export…</source>
        <translation>書き出す…</translation>
    </message>
    <message>
        <source>How far the left one is from the mirror image of the right one about this patient's own midplane [mm]</source>
        <translation>この患者の正中面で右の点を折り返した像と左の点の距離 [mm]</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>計測</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>計測値</translation>
    </message>
    <message>
        <source>Norm of</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>Section</source>
        <translation>断面</translation>
    </message>
    <message>
        <source>The norms cover 20 to 25 years and are held beyond</source>
        <translation>基準値は 20～25 歳のもので、それ以外の年齢では両端の値を使います</translation>
    </message>
    <message>
        <source>Volumes</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました：%1</translation>
    </message>
    <message>
        <source>angle against the line of the inner canthi</source>
        <translation>左右の目頭を結ぶ線に対する角度</translation>
    </message>
    <message>
        <source>angle at the middle point</source>
        <translation>中央の点での角度</translation>
    </message>
    <message>
        <source>before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>change</source>
        <translation>変化</translation>
    </message>
    <message>
        <source>depth in front of the inner canthi</source>
        <translation>目頭から前への深さ</translation>
    </message>
    <message>
        <source>in front of the nasion, at right angles to the face's height</source>
        <translation>ナジオンから前へ、顔の高さに直角に</translation>
    </message>
    <message>
        <source>men</source>
        <translation>男性</translation>
    </message>
    <message>
        <source>norm</source>
        <translation>基準</translation>
    </message>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>sides differ: %1</source>
        <translation>左右差：%1</translation>
    </message>
    <message>
        <source>straight distance; of pairs the mean of both sides</source>
        <translation>直線距離（左右があるものは両側の平均）</translation>
    </message>
    <message>
        <source>women</source>
        <translation>女性</translation>
    </message>
    <message>
        <source>women and men</source>
        <translation>男女</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>MusclePanel</name>
    <message>
        <source>%1 %</source>
        <translation>%1 %</translation>
    </message>
    <message>
        <source>%1 % strong</source>
        <translation>筋力 %1 %</translation>
    </message>
    <message>
        <source>%1 years</source>
        <translation>%1 歳</translation>
    </message>
    <message>
        <source>%1, left</source>
        <translation>%1（左）</translation>
    </message>
    <message>
        <source>%1, right</source>
        <translation>%1（右）</translation>
    </message>
    <message>
        <source>A preset adds to what the muscles do, instead of taking its place</source>
        <translation>プリセットを現在の筋の動きに加えます（置き換えません）</translation>
    </message>
    <message>
        <source>A preset is reached by and by, within 0.4 seconds</source>
        <translation>0.4 秒かけてプリセットに移ります</translation>
    </message>
    <message>
        <source>Add</source>
        <translation>加える</translation>
    </message>
    <message>
        <source>Age of the skin</source>
        <translation>皮膚の年齢</translation>
    </message>
    <message>
        <source>Age of the skin: how deep expressions wrinkle it</source>
        <translation>皮膚の年齢：表情じわの深さ</translation>
    </message>
    <message>
        <source>All at rest</source>
        <translation>すべて安静</translation>
    </message>
    <message>
        <source>All muscles at full strength</source>
        <translation>すべて完全な筋力</translation>
    </message>
    <message>
        <source>Balance of the sides</source>
        <translation>左右のつり合い</translation>
    </message>
    <message>
        <source>Balance of the sides: to the left, the patient's right side does more; to the right, the left side</source>
        <translation>左右のつり合い：左へ動かすと患者の右側が、右へ動かすと左側が強く働きます</translation>
    </message>
    <message>
        <source>Beside untreated</source>
        <translation>治療前と並べる</translation>
    </message>
    <message>
        <source>Both sides together</source>
        <translation>両側を一緒に</translation>
    </message>
    <message>
        <source>Chin</source>
        <translation>オトガイ</translation>
    </message>
    <message>
        <source>Contraction; double click: at rest</source>
        <translation>収縮。ダブルクリックで安静</translation>
    </message>
    <message>
        <source>Expression</source>
        <translation>表情</translation>
    </message>
    <message>
        <source>Expression …</source>
        <translation>表情…</translation>
    </message>
    <message>
        <source>Eyes</source>
        <translation>目</translation>
    </message>
    <message>
        <source>Find a muscle or action unit</source>
        <translation>筋または動作単位を探す</translation>
    </message>
    <message>
        <source>Forehead and brow</source>
        <translation>額と眉</translation>
    </message>
    <message>
        <source>Glide</source>
        <translation>なめらかに</translation>
    </message>
    <message>
        <source>Intensity of the expression</source>
        <translation>表情の強さ</translation>
    </message>
    <message>
        <source>Intensity of the expression: A a trace … E the most</source>
        <translation>表情の強さ：A わずか … E 最大</translation>
    </message>
    <message>
        <source>Jaw and chewing</source>
        <translation>顎と咀嚼</translation>
    </message>
    <message>
        <source>Keep a preset</source>
        <translation>プリセットを保存</translation>
    </message>
    <message>
        <source>Keeps what the sliders show as a preset of your own</source>
        <translation>スライダーの状態を自分のプリセットとして保存します</translation>
    </message>
    <message>
        <source>Mouth and cheek</source>
        <translation>口と頬</translation>
    </message>
    <message>
        <source>Muscles weakened by toxin or palsy: they do less of every expression</source>
        <translation>毒素や麻痺で弱った筋：どの表情でも働きが小さくなります</translation>
    </message>
    <message>
        <source>Name of the preset:</source>
        <translation>プリセットの名前：</translation>
    </message>
    <message>
        <source>Neck</source>
        <translation>首</translation>
    </message>
    <message>
        <source>Nose</source>
        <translation>鼻</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>削除</translation>
    </message>
    <message>
        <source>Removes this preset of your own</source>
        <translation>この自分のプリセットを削除します</translation>
    </message>
    <message>
        <source>Save…</source>
        <translation>保存…</translation>
    </message>
    <message>
        <source>Sets every muscle back to rest</source>
        <translation>すべての筋を安静に戻します</translation>
    </message>
    <message>
        <source>Shows the same expression with all muscles at full strength beside this one</source>
        <translation>すべての筋が本来の強さの場合の同じ表情を並べて示します</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>側</translation>
    </message>
    <message>
        <source>Strength</source>
        <translation>筋力</translation>
    </message>
    <message>
        <source>Strength: how much of its contraction the muscle can do</source>
        <translation>筋力：収縮のうちどれだけできるか</translation>
    </message>
    <message>
        <source>Weak muscles</source>
        <translation>弱い筋</translation>
    </message>
    <message>
        <source>Wrinkles</source>
        <translation>しわ</translation>
    </message>
    <message>
        <source>both sides</source>
        <translation>両側</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
</context>
<context>
    <name>PassphraseWords</name>
    <message>
        <source>At least %1 letters.</source>
        <translation>%1 文字以上にしてください。</translation>
    </message>
    <message>
        <source>No passphrase any more</source>
        <translation>パスフレーズを外す</translation>
    </message>
    <message>
        <source>Once more</source>
        <translation>もう一度</translation>
    </message>
    <message>
        <source>Passphrase</source>
        <translation>パスフレーズ</translation>
    </message>
    <message>
        <source>Passphrase:</source>
        <translation>パスフレーズ:</translation>
    </message>
    <message>
        <source>Protect the case</source>
        <translation>症例の保護</translation>
    </message>
    <message>
        <source>Protected case</source>
        <translation>保護された症例</translation>
    </message>
    <message>
        <source>The case and what is kept for recovery are encrypted (AES-256) the next time they are written. Without the passphrase nobody can open them, not even you: keep it somewhere safe. Several words are better than a short riddle.</source>
        <translation>症例と復旧用の記録は、次に書き込まれるときに暗号化(AES-256)されます。パスフレーズがなければ、あなた自身も含めて誰も開けません。安全な場所に控えてください。短い暗号めいた語より、いくつかの単語を並べる方が安全です。</translation>
    </message>
    <message>
        <source>The two are not the same yet.</source>
        <translation>二つがまだ一致していません。</translation>
    </message>
</context>
<context>
    <name>PatientView</name>
    <message>
        <source>Myoface — patient</source>
        <translation>Myoface — 患者用</translation>
    </message>
</context>
<context>
    <name>PlanFiles</name>
    <message>
        <source>
Edit %1 (%2) was left out: %3</source>
        <translation>
編集 %1(%2)は省かれました: %3</translation>
    </message>
    <message>
        <source>
Look at edit %1: fit and landmarks put its place %2 mm apart.</source>
        <translation>
編集 %1 を確認してください: 当てはめと計測点で位置が %2 mm ずれています。</translation>
    </message>
    <message>
        <source>%1 of %2 edits of the plan were made.</source>
        <translation>計画の編集 %2 件のうち %1 件を行いました。</translation>
    </message>
    <message>
        <source>Apply a plan</source>
        <translation>計画を適用</translation>
    </message>
    <message>
        <source>Applying the plan…</source>
        <translation>計画を適用しています…</translation>
    </message>
    <message>
        <source>Export the plan</source>
        <translation>計画を書き出す</translation>
    </message>
    <message>
        <source>Nothing has been done to this face yet: there is no plan to write.</source>
        <translation>この顔にはまだ何も行われていないので、書き出す計画がありません。</translation>
    </message>
    <message>
        <source>Plan (*.json)</source>
        <translation>計画 (*.json)</translation>
    </message>
    <message>
        <source>Plans (*.json);;All files (*)</source>
        <translation>計画 (*.json);;すべてのファイル (*)</translation>
    </message>
    <message>
        <source>They were carried over from another scan through the fit.</source>
        <translation>別のスキャンから当てはめを通して移されました。</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました：%1</translation>
    </message>
    <message>
        <source>plan %1</source>
        <translation>計画 %1</translation>
    </message>
</context>
<context>
    <name>Preferences</name>
    <message>
        <source>Close</source>
        <translation>閉じる</translation>
    </message>
    <message>
        <source>Cosine over that of the sector's edge, less one; ramped down beyond the start of the falloff.</source>
        <translation>角の余弦を扇形の端の余弦で割って 1 を引き、減衰の始まりより先で下げます。</translation>
    </message>
    <message>
        <source>Equations (7) and (8) to the letter. The skin tears at the end of the falloff and at the edge of the sector.</source>
        <translation>式 (7) と (8) のままです。減衰の終わりと扇形の端で皮膚が裂けます。</translation>
    </message>
    <message>
        <source>Half the angle's cosine across the sector, quarter-turn curves along it.</source>
        <translation>扇形を横切る向きは半角の余弦、沿う向きは四分の一周の曲線です。</translation>
    </message>
    <message>
        <source>Language</source>
        <translation>言語</translation>
    </message>
    <message>
        <source>Look</source>
        <translation>外観</translation>
    </message>
    <message>
        <source>Method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>Preferences</source>
        <translation>設定</translation>
    </message>
    <message>
        <source>Response of linear muscles</source>
        <translation>線状筋の応答</translation>
    </message>
    <message>
        <source>Smooth in slope along and across the fibre: nothing tears, no edge is seen.</source>
        <translation>線維に沿う向きも横切る向きも傾きが滑らかで、裂け目も縁も見えません。</translation>
    </message>
    <message>
        <source>The cosine across the sector reaches nothing at its edge.</source>
        <translation>横切る向きの余弦が扇形の端で 0 になります。</translation>
    </message>
    <message>
        <source>The radial cosines scaled to a quarter turn, so that the falloff ends at nothing.</source>
        <translation>動径方向の余弦を四分の一周に合わせ、減衰が 0 で終わります。</translation>
    </message>
    <message>
        <source>Theme</source>
        <translation>配色</translation>
    </message>
    <message>
        <source>Waters 1987</source>
        <translation>Waters 1987</translation>
    </message>
    <message>
        <source>as in later programs</source>
        <translation>後年のプログラムの式</translation>
    </message>
    <message>
        <source>as printed in the paper</source>
        <translation>論文の式のまま</translation>
    </message>
    <message>
        <source>as printed, over a quarter turn</source>
        <translation>論文の式、四分の一周</translation>
    </message>
    <message>
        <source>as the system</source>
        <translation>システムに合わせる</translation>
    </message>
    <message>
        <source>dark: the face is the brightest thing</source>
        <translation>暗い：顔が最も明るく見えます</translation>
    </message>
    <message>
        <source>light: for bright rooms</source>
        <translation>明るい：明るい部屋向け</translation>
    </message>
    <message>
        <source>normalised to its zone</source>
        <translation>範囲で正規化</translation>
    </message>
    <message>
        <source>smooth (usual)</source>
        <translation>滑らか（通常）</translation>
    </message>
</context>
<context>
    <name>QObject</name>
    <message>
        <source>1, 2 or 4 sides of the face at once</source>
        <translation>顔の 1・2・4 方向を同時に表示</translation>
    </message>
    <message>
        <source>Facial surgery consultation simulator. A planning and communication aid, not a medical device.</source>
        <translation>顔面手術の説明用シミュレーター。計画と説明のための補助であり、医療機器ではありません。</translation>
    </message>
    <message>
        <source>NAME=c, contraction; repeatable</source>
        <translation>名前=c、収縮。繰り返し可</translation>
    </message>
    <message>
        <source>NAME=s, of a muscle; repeatable</source>
        <translation>名前=s、筋力。繰り返し可</translation>
    </message>
    <message>
        <source>NAME=w, intensity; repeatable</source>
        <translation>名前=w、強さ。繰り返し可</translation>
    </message>
    <message>
        <source>OBJ, PLY or .myoface file, or the word generic</source>
        <translation>OBJ・PLY・.myoface ファイル、または generic</translation>
    </message>
    <message>
        <source>This computer offers no OpenGL 3.3, which the 3D view needs. Install or update its graphics driver; myoface-cli works without.</source>
        <translation>3D 表示に必要な OpenGL 3.3 がこのコンピューターにありません。グラフィックスドライバーを入れるか更新してください。myoface-cli はそのまま使えます。</translation>
    </message>
    <message>
        <source>a level cut through this landmark</source>
        <translation>このランドマークを通る水平断面</translation>
    </message>
    <message>
        <source>dark or light</source>
        <translation>dark または light</translation>
    </message>
    <message>
        <source>en or ja</source>
        <translation>en または ja</translation>
    </message>
    <message>
        <source>layers, scan, landmarks, shape or muscles in front</source>
        <translation>手前に出す layers、scan、landmarks、shape、muscles など</translation>
    </message>
    <message>
        <source>of skin,muscle,bone,springs</source>
        <translation>skin,muscle,bone,springs から</translation>
    </message>
    <message>
        <source>of the window [px]</source>
        <translation>ウィンドウの大きさ [px]</translation>
    </message>
    <message>
        <source>off, side, wipe, ghost, map or sides</source>
        <translation>off、side、wipe、ghost、map、sides のいずれか</translation>
    </message>
    <message>
        <source>save the window as PNG and end</source>
        <translation>ウィンドウを PNG で保存して終わる</translation>
    </message>
    <message>
        <source>scan, fit, shape, expression, compare or report</source>
        <translation>scan、fit、shape、expression、compare、report</translation>
    </message>
    <message>
        <source>show landmarks and fitted head</source>
        <translation>特徴点と当てはめた頭を表示する</translation>
    </message>
    <message>
        <source>standard view</source>
        <translation>標準の向き</translation>
    </message>
    <message>
        <source>years of the skin that wrinkles, 18 to 80</source>
        <translation>しわの元になる皮膚の年齢（18〜80 歳）</translation>
    </message>
</context>
<context>
    <name>ReportPanel</name>
    <message>
        <source>A film all around the head: PNG pictures in a folder, or GIF or MP4 where ffmpeg or ImageMagick is installed</source>
        <translation>頭部を一周する動画：フォルダー内の PNG 画像、または ffmpeg か ImageMagick があれば GIF・MP4</translation>
    </message>
    <message>
        <source>A film from rest to the face as it is and back: PNG pictures, GIF or MP4</source>
        <translation>安静から今の顔まで動いて戻る動画：PNG 画像、GIF、MP4</translation>
    </message>
    <message>
        <source>A planning and communication aid, not a medical device: what is shown is an estimate, not a promise of a result.</source>
        <translation>計画と説明のための補助であり、医療機器ではありません。表示は推定であり、結果を約束するものではありません。</translation>
    </message>
    <message>
        <source>Anonymous: no skin texture, no name, a bar over the eyes</source>
        <translation>匿名：皮膚の画像と名前なし、目に帯</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>選ぶ…</translation>
    </message>
    <message>
        <source>Expression moving…</source>
        <translation>表情の動き…</translation>
    </message>
    <message>
        <source>Face as mesh…</source>
        <translation>顔のメッシュ…</translation>
    </message>
    <message>
        <source>Facial simulation</source>
        <translation>顔面シミュレーション</translation>
    </message>
    <message>
        <source>Head turning…</source>
        <translation>頭部の回転…</translation>
    </message>
    <message>
        <source>Logo</source>
        <translation>ロゴ</translation>
    </message>
    <message>
        <source>Logo of the clinic</source>
        <translation>医院のロゴ</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>OBJ, PLY, GLB, or STL for printing; anonymous: STL alone</source>
        <translation>OBJ、PLY、GLB、3D プリント用の STL。匿名のときは STL だけ</translation>
    </message>
    <message>
        <source>Other files</source>
        <translation>その他のファイル</translation>
    </message>
    <message>
        <source>Patient</source>
        <translation>患者用</translation>
    </message>
    <message>
        <source>Pictures (*.png *.jpg *.jpeg)</source>
        <translation>画像 (*.png *.jpg *.jpeg)</translation>
    </message>
    <message>
        <source>Picture…</source>
        <translation>画像…</translation>
    </message>
    <message>
        <source>Printed report</source>
        <translation>印刷する報告書</translation>
    </message>
    <message>
        <source>Save case…</source>
        <translation>症例を保存…</translation>
    </message>
    <message>
        <source>Scan, fit, plan, variants and notes in one file</source>
        <translation>スキャン・当てはめ・計画・案・メモを一つのファイルに</translation>
    </message>
    <message>
        <source>The view as it is, as PNG</source>
        <translation>今の表示を PNG で</translation>
    </message>
    <message>
        <source>Title</source>
        <translation>表題</translation>
    </message>
    <message>
        <source>Write the report (PDF)…</source>
        <translation>報告書を書く（PDF）…</translation>
    </message>
    <message>
        <source>Writing the report…</source>
        <translation>報告書を作成中…</translation>
    </message>
    <message>
        <source>a pseudonym</source>
        <translation>仮名</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
</context>
<context>
    <name>ResponsePlot</name>
    <message>
        <source>Response along and across the fibre</source>
        <translation>線維に沿う応答と横切る応答</translation>
    </message>
    <message>
        <source>across the fibre</source>
        <translation>線維を横切る向き</translation>
    </message>
    <message>
        <source>along the fibre, from the bone</source>
        <translation>線維に沿って、骨から</translation>
    </message>
</context>
<context>
    <name>ScanFrameEditor</name>
    <message>
        <source>Calibration: click the first of two points whose distance you know (Esc ends it).</source>
        <translation>較正：距離の分かっている 2 点の最初の点をクリックしてください（Esc で終わります）。</translation>
    </message>
    <message>
        <source>Calibration: click the second point.</source>
        <translation>較正：2 番目の点をクリックしてください。</translation>
    </message>
</context>
<context>
    <name>ScanPanel</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>%1 × %2 × %3 mm</source>
        <translation>%1 × %2 × %3 mm</translation>
    </message>
    <message>
        <source>%1, the longest %2 mm around</source>
        <translation>%1（最も長いものは周囲 %2 mm）</translation>
    </message>
    <message>
        <source>Calibrate by a known distance…</source>
        <translation>既知の距離で較正…</translation>
    </message>
    <message>
        <source>Click two points whose distance you know: a ruler in the scan, the width of the iris (about 11.7 mm), a measured width of the face.</source>
        <translation>距離の分かっている 2 点をクリックします：スキャンの中の物差し、虹彩の幅（約 11.7 mm）、実測した顔の幅など。</translation>
    </message>
    <message>
        <source>Colour</source>
        <translation>色</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>File</source>
        <translation>ファイル</translation>
    </message>
    <message>
        <source>Format</source>
        <translation>形式</translation>
    </message>
    <message>
        <source>Found by the shape of the face, %1 % sure.</source>
        <translation>顔の形から判断しました（確かさ %1 %）。</translation>
    </message>
    <message>
        <source>Landmarks</source>
        <translation>特徴点</translation>
    </message>
    <message>
        <source>Muscles</source>
        <translation>筋</translation>
    </message>
    <message>
        <source>No face is open.</source>
        <translation>顔が開かれていません。</translation>
    </message>
    <message>
        <source>Nod</source>
        <translation>うなずき</translation>
    </message>
    <message>
        <source>Openings</source>
        <translation>開口</translation>
    </message>
    <message>
        <source>Parts that do not hang together with the face: eyeballs, lashes, hair, scraps</source>
        <translation>顔とつながっていない部分：眼球、まつ毛、髪、破片</translation>
    </message>
    <message>
        <source>Show the loose parts (%1)</source>
        <translation>離れた部分を表示（%1）</translation>
    </message>
    <message>
        <source>Size</source>
        <translation>大きさ</translation>
    </message>
    <message>
        <source>Spin</source>
        <translation>回転</translation>
    </message>
    <message>
        <source>Springs</source>
        <translation>ばね</translation>
    </message>
    <message>
        <source>The file's axes: %1.</source>
        <translation>ファイルの軸：%1。</translation>
    </message>
    <message>
        <source>The unit follows from the landmarks.</source>
        <translation>単位は特徴点から分かりました。</translation>
    </message>
    <message>
        <source>Tilt</source>
        <translation>傾け</translation>
    </message>
    <message>
        <source>Turn</source>
        <translation>回す</translation>
    </message>
    <message>
        <source>Turn by a quarter about the axis from ear to ear</source>
        <translation>耳から耳への軸で四分の一回転</translation>
    </message>
    <message>
        <source>Turn by a quarter about the axis through the nose</source>
        <translation>鼻を通る軸で四分の一回転</translation>
    </message>
    <message>
        <source>Turn by a quarter about the upright axis</source>
        <translation>縦の軸で四分の一回転</translation>
    </message>
    <message>
        <source>Unit</source>
        <translation>単位</translation>
    </message>
    <message>
        <source>Vertices</source>
        <translation>頂点</translation>
    </message>
    <message>
        <source>What one unit of the file is. Files do not say it.</source>
        <translation>ファイルの 1 単位の長さ。ファイルには書かれていません。</translation>
    </message>
    <message>
        <source>back</source>
        <translation>後ろ</translation>
    </message>
    <message>
        <source>centimetre</source>
        <translation>センチメートル</translation>
    </message>
    <message>
        <source>decimetre</source>
        <translation>デシメートル</translation>
    </message>
    <message>
        <source>down</source>
        <translation>下</translation>
    </message>
    <message>
        <source>front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>inch</source>
        <translation>インチ</translation>
    </message>
    <message>
        <source>left</source>
        <translation>左</translation>
    </message>
    <message>
        <source>metre</source>
        <translation>メートル</translation>
    </message>
    <message>
        <source>millimetre</source>
        <translation>ミリメートル</translation>
    </message>
    <message>
        <source>none</source>
        <translation>なし</translation>
    </message>
    <message>
        <source>per vertex</source>
        <translation>頂点ごと</translation>
    </message>
    <message>
        <source>right</source>
        <translation>右</translation>
    </message>
    <message>
        <source>up</source>
        <translation>上</translation>
    </message>
</context>
<context>
    <name>SectionPlot</name>
    <message>
        <source>%1 mm</source>
        <translation>%1 mm</translation>
    </message>
    <message>
        <source>A cut through the face: grey before, blue now; the grid is in millimetres</source>
        <translation>顔の断面：灰色が前、青が今。方眼はミリメートル</translation>
    </message>
    <message>
        <source>Section before and now</source>
        <translation>前と今の断面</translation>
    </message>
</context>
<context>
    <name>SectionView</name>
    <message>
        <source>Apart by up to %1 mm</source>
        <translation>差は最大 %1 mm</translation>
    </message>
    <message>
        <source>CSV (*.csv)</source>
        <translation>CSV (*.csv)</translation>
    </message>
    <message>
        <source>CSV…</source>
        <translation>CSV…</translation>
    </message>
    <message>
        <source>Export the section</source>
        <translation>断面を書き出す</translation>
    </message>
    <message>
        <source>Free cut</source>
        <translation>自由な断面</translation>
    </message>
    <message>
        <source>Kind of section</source>
        <translation>断面の種類</translation>
    </message>
    <message>
        <source>Level cut</source>
        <translation>水平断面</translation>
    </message>
    <message>
        <source>Profile</source>
        <translation>側貌</translation>
    </message>
    <message>
        <source>The lines of the section in millimetres, for a spreadsheet</source>
        <translation>断面の線をミリメートルで、表計算用に</translation>
    </message>
    <message>
        <source>The plane does not meet the face.</source>
        <translation>この面は顔と交わりません。</translation>
    </message>
    <message>
        <source>Upright cut beside the midplane</source>
        <translation>正中面に平行な縦断面</translation>
    </message>
    <message>
        <source>With the tool Section (S), a click on the face says where it is cut; a line drawn across the face cuts along it</source>
        <translation>断面ツール (S) で、顔のクリックした所を切ります。顔を横切る線を引くと、その線に沿って切ります</translation>
    </message>
    <message>
        <source>Written: %1</source>
        <translation>書き出しました：%1</translation>
    </message>
</context>
<context>
    <name>ShapePanel</name>
    <message>
        <source>  (%1%2 against the scan)</source>
        <translation>  （スキャンから %1%2）</translation>
    </message>
    <message>
        <source> mL</source>
        <translation> mL</translation>
    </message>
    <message>
        <source> mm</source>
        <translation> mm</translation>
    </message>
    <message>
        <source>As broad as suits the region and the depth of the tissue</source>
        <translation>部位と組織の厚さに合った広さ</translation>
    </message>
    <message>
        <source>By numbers</source>
        <translation>数値で</translation>
    </message>
    <message>
        <source>Hand</source>
        <translation>手</translation>
    </message>
    <message>
        <source>Measure</source>
        <translation>計測</translation>
    </message>
    <message>
        <source>Move</source>
        <translation>動かす</translation>
    </message>
    <message>
        <source>Moves the landmark until the measure is met; tissue follows</source>
        <translation>計測値が合うまで特徴点を動かします。組織が従います</translation>
    </message>
    <message>
        <source>Moves the point gripped last, in the plane of the picture; arrow keys: 0.1 mm, with Shift 1 mm</source>
        <translation>最後につかんだ点を画面の面内で動かします。矢印キー：0.1 mm、Shift で 1 mm</translation>
    </message>
    <message>
        <source>Paints the stress kernel of the place under the cursor: further along the same muscle</source>
        <translation>カーソルの所の応力の広がりを塗ります：同じ筋に沿って遠くまで</translation>
    </message>
    <message>
        <source>Protect nothing</source>
        <translation>保護をやめる</translation>
    </message>
    <message>
        <source>Protect tool erases</source>
        <translation>保護の筆で消す</translation>
    </message>
    <message>
        <source>Radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>Radius of the grip</source>
        <translation>つかむ半径</translation>
    </message>
    <message>
        <source>Radius of the grip; F and a move of the mouse changes it on the face</source>
        <translation>つかむ半径。F を押してマウスを動かすと顔の上で変えられます</translation>
    </message>
    <message>
        <source>Right, up</source>
        <translation>右、上</translation>
    </message>
    <message>
        <source>Same on the other side (X)</source>
        <translation>反対側も同じに (X)</translation>
    </message>
    <message>
        <source>Shape</source>
        <translation>形</translation>
    </message>
    <message>
        <source>Show how far the grip reaches</source>
        <translation>つかむ範囲を表示</translation>
    </message>
    <message>
        <source>To the right</source>
        <translation>右へ</translation>
    </message>
    <message>
        <source>Until a measure is</source>
        <translation>計測値が次になるまで</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>上へ</translation>
    </message>
    <message>
        <source>Volume</source>
        <translation>体積</translation>
    </message>
    <message>
        <source>Wanted value</source>
        <translation>目標の値</translation>
    </message>
    <message>
        <source>Way</source>
        <translation>向き</translation>
    </message>
    <message>
        <source>What a click with the Volume tool adds, or takes away below zero</source>
        <translation>体積の道具の 1 クリックで加える量。0 より小さいと取り除きます</translation>
    </message>
    <message>
        <source>Where the grabbed point may go</source>
        <translation>つかんだ点が動ける向き</translation>
    </message>
    <message>
        <source>anywhere</source>
        <translation>自由</translation>
    </message>
    <message>
        <source>by region</source>
        <translation>部位に合わせる</translation>
    </message>
    <message>
        <source>in and out of the skin</source>
        <translation>皮膚に垂直</translation>
    </message>
    <message>
        <source>in the midplane's direction</source>
        <translation>正中面の中で</translation>
    </message>
    <message>
        <source>now</source>
        <translation>現在</translation>
    </message>
    <message>
        <source>unknown: landmarks are missing</source>
        <translation>不明：特徴点がありません</translation>
    </message>
    <message>
        <source>wanted</source>
        <translation>目標</translation>
    </message>
    <message>
        <source>°</source>
        <translation>°</translation>
    </message>
</context>
<context>
    <name>ShapeTools</name>
    <message>
        <source>%1 N</source>
        <translation>%1 N</translation>
    </message>
    <message>
        <source>Grip a place of the face first; then it can be moved by numbers.</source>
        <translation>先に顔の一点をつかんでください。その後、数値で動かせます。</translation>
    </message>
    <message>
        <source>Radius of the grip %1 mm — click to take it, Esc to leave it</source>
        <translation>つかむ半径 %1 mm — クリックで決定、Esc で取りやめ</translation>
    </message>
    <message>
        <source>The skin would have folded over itself: %1 % of the shape stay.</source>
        <translation>皮膚が折り重なるため、形の %1 % だけを残しました。</translation>
    </message>
    <message>
        <source>hold %1 N</source>
        <translation>保持 %1 N</translation>
    </message>
    <message>
        <source>hold %1 N · bone holds back %2 mm</source>
        <translation>保持 %1 N · 骨が %2 mm 引き留めています</translation>
    </message>
    <message>
        <source>protect nothing</source>
        <translation>保護なし</translation>
    </message>
    <message>
        <source>protected skin</source>
        <translation>保護した皮膚</translation>
    </message>
    <message>
        <source>pull %1 N: skin %2, muscle %3, held back %4 · %5 mm behind the hand</source>
        <translation>引く力 %1 N：皮膚 %2、筋 %3、引き留め %4 · 手から %5 mm 遅れ</translation>
    </message>
    <message>
        <source>shape by %1 mm</source>
        <translation>形 %1 mm</translation>
    </message>
</context>
<context>
    <name>SimulationWorker</name>
    <message>
        <source>
%1 %2%3</source>
        <translation>
%1 %2%3</translation>
    </message>
    <message>
        <source>
nothing worth mentioning</source>
        <translation>
目立った変化はありません</translation>
    </message>
    <message>
        <source>%1 %2</source>
        <translation>%1 %2</translation>
    </message>
    <message>
        <source>%1 mL, at %2 kPa in the middle.</source>
        <translation>%1 mL、中央で %2 kPa。</translation>
    </message>
    <message>
        <source>%1: %2 before, %3 now; %4 moved by %5 mm.</source>
        <translation>%1：前 %2、現在 %3。%4 が %5 mm 動きました。</translation>
    </message>
    <message>
        <source>Moved by %1 mm; the hand would have to hold %2 N.</source>
        <translation>%1 mm 動きました。手には %2 N が必要です。</translation>
    </message>
    <message>
        <source>The shape has changed by, in mL:</source>
        <translation>形の変化（mL）：</translation>
    </message>
    <message>
        <source>volume %1 mL</source>
        <translation>体積 %1 mL</translation>
    </message>
</context>
<context>
    <name>VolumePlot</name>
    <message>
        <source>Millilitres that came to each region since before, or went from it</source>
        <translation>前に比べて各部位に増えた、または減ったミリリットル</translation>
    </message>
    <message>
        <source>No volume has changed.</source>
        <translation>体積の変化はありません。</translation>
    </message>
    <message>
        <source>Volume by region</source>
        <translation>部位ごとの体積</translation>
    </message>
    <message>
        <source>in all %1 mL</source>
        <translation>合計 %1 mL</translation>
    </message>
</context>
<context>
    <name>core</name>
    <message>
        <source>Anger</source>
        <translation>怒り</translation>
    </message>
    <message>
        <source>Brow raise</source>
        <translation>眉上げ</translation>
    </message>
    <message>
        <source>Buccinator</source>
        <translation>頬筋</translation>
    </message>
    <message>
        <source>Building the face</source>
        <translation>顔を組み立てています</translation>
    </message>
    <message>
        <source>Checking</source>
        <translation>調べています</translation>
    </message>
    <message>
        <source>Contempt</source>
        <translation>軽蔑</translation>
    </message>
    <message>
        <source>Corrugator supercilii</source>
        <translation>皺眉筋</translation>
    </message>
    <message>
        <source>Depressor anguli oris</source>
        <translation>口角下制筋</translation>
    </message>
    <message>
        <source>Depressor labii inferioris</source>
        <translation>下唇下制筋</translation>
    </message>
    <message>
        <source>Depressor septi nasi</source>
        <translation>鼻中隔下制筋</translation>
    </message>
    <message>
        <source>Depressor supercilii</source>
        <translation>眉毛下制筋</translation>
    </message>
    <message>
        <source>Disgust</source>
        <translation>嫌悪</translation>
    </message>
    <message>
        <source>Eyes closed</source>
        <translation>閉眼</translation>
    </message>
    <message>
        <source>Eyes tightly closed</source>
        <translation>強い閉眼</translation>
    </message>
    <message>
        <source>Facial palsy, grade II (slight)</source>
        <translation>顔面麻痺 II 度（軽度）</translation>
    </message>
    <message>
        <source>Facial palsy, grade III (moderate)</source>
        <translation>顔面麻痺 III 度（中等度）</translation>
    </message>
    <message>
        <source>Facial palsy, grade IV (moderately severe)</source>
        <translation>顔面麻痺 IV 度（やや高度）</translation>
    </message>
    <message>
        <source>Facial palsy, grade V (severe)</source>
        <translation>顔面麻痺 V 度（高度）</translation>
    </message>
    <message>
        <source>Facial palsy, grade VI (total)</source>
        <translation>顔面麻痺 VI 度（完全）</translation>
    </message>
    <message>
        <source>Fear</source>
        <translation>恐れ</translation>
    </message>
    <message>
        <source>Finding landmarks</source>
        <translation>特徴点を探しています</translation>
    </message>
    <message>
        <source>Fitting the face</source>
        <translation>顔を当てはめています</translation>
    </message>
    <message>
        <source>Frontalis, lateral part</source>
        <translation>前頭筋（外側）</translation>
    </message>
    <message>
        <source>Frontalis, medial part</source>
        <translation>前頭筋（内側）</translation>
    </message>
    <message>
        <source>Frown</source>
        <translation>眉しかめ</translation>
    </message>
    <message>
        <source>Full smile</source>
        <translation>満面の笑み</translation>
    </message>
    <message>
        <source>Gentle smile</source>
        <translation>微笑</translation>
    </message>
    <message>
        <source>Incisivii labii</source>
        <translation>切歯筋</translation>
    </message>
    <message>
        <source>Jaw open</source>
        <translation>開口</translation>
    </message>
    <message>
        <source>Jaw opening</source>
        <translation>開口</translation>
    </message>
    <message>
        <source>Joy</source>
        <translation>喜び</translation>
    </message>
    <message>
        <source>Lateral pterygoid</source>
        <translation>外側翼突筋</translation>
    </message>
    <message>
        <source>Levator anguli oris</source>
        <translation>口角挙筋</translation>
    </message>
    <message>
        <source>Levator labii superioris</source>
        <translation>上唇挙筋</translation>
    </message>
    <message>
        <source>Levator labii superioris alaeque nasi</source>
        <translation>上唇鼻翼挙筋</translation>
    </message>
    <message>
        <source>Levator palpebrae superioris</source>
        <translation>上眼瞼挙筋</translation>
    </message>
    <message>
        <source>Looking for the face</source>
        <translation>顔を探しています</translation>
    </message>
    <message>
        <source>Masseter</source>
        <translation>咬筋</translation>
    </message>
    <message>
        <source>Mentalis</source>
        <translation>オトガイ筋</translation>
    </message>
    <message>
        <source>Nasalis, alar part</source>
        <translation>鼻筋（翼部）</translation>
    </message>
    <message>
        <source>Nasalis, transverse part</source>
        <translation>鼻筋（横部）</translation>
    </message>
    <message>
        <source>Orbicularis oculi, orbital part</source>
        <translation>眼輪筋（眼窩部）</translation>
    </message>
    <message>
        <source>Orbicularis oculi, palpebral part</source>
        <translation>眼輪筋（眼瞼部）</translation>
    </message>
    <message>
        <source>Orbicularis oris, lower lip</source>
        <translation>口輪筋（下唇）</translation>
    </message>
    <message>
        <source>Orbicularis oris, upper lip</source>
        <translation>口輪筋（上唇）</translation>
    </message>
    <message>
        <source>Painting the skin</source>
        <translation>皮膚を塗っています</translation>
    </message>
    <message>
        <source>Platysma</source>
        <translation>広頸筋</translation>
    </message>
    <message>
        <source>Procerus</source>
        <translation>鼻根筋</translation>
    </message>
    <message>
        <source>Pucker</source>
        <translation>口すぼめ</translation>
    </message>
    <message>
        <source>Reading</source>
        <translation>読み込んでいます</translation>
    </message>
    <message>
        <source>Risorius</source>
        <translation>笑筋</translation>
    </message>
    <message>
        <source>Sadness</source>
        <translation>悲しみ</translation>
    </message>
    <message>
        <source>Show teeth</source>
        <translation>歯を見せる</translation>
    </message>
    <message>
        <source>Snarl</source>
        <translation>鼻しかめ</translation>
    </message>
    <message>
        <source>Surprise</source>
        <translation>驚き</translation>
    </message>
    <message>
        <source>Temporalis</source>
        <translation>側頭筋</translation>
    </message>
    <message>
        <source>The angle of the jaw: its lowest, hindmost and outermost point.</source>
        <translation>下顎角。最も下・後ろ・外側の点。</translation>
    </message>
    <message>
        <source>The bony root of the nose in the midline, over the nasofrontal suture: above the deepest point of the bridge.</source>
        <translation>正中の骨の鼻根、前頭鼻骨縫合の上。鼻背の最も深い点より上。</translation>
    </message>
    <message>
        <source>The border between the red of the lower lip and the skin, in the midline.</source>
        <translation>正中で、下唇の赤唇と皮膚の境。</translation>
    </message>
    <message>
        <source>The border between the skin and the red of the upper lip, in the midline.</source>
        <translation>正中で、上唇の皮膚と赤唇の境。</translation>
    </message>
    <message>
        <source>The corner of the mouth, where the line between the lips ends.</source>
        <translation>口角。唇の合わせ目の端。</translation>
    </message>
    <message>
        <source>The deepest point of the bridge of the nose in the midline, about as high as the upper lids.</source>
        <translation>正中で鼻背の最も深い点。ほぼ上まぶたの高さ。</translation>
    </message>
    <message>
        <source>The deepest point of the fold between lower lip and chin.</source>
        <translation>下唇とオトガイの間の溝の最も深い点。</translation>
    </message>
    <message>
        <source>The foremost point of the chin in the midline.</source>
        <translation>正中でオトガイの最も前の点。</translation>
    </message>
    <message>
        <source>The foremost point of the columella, at the crest between the nostrils.</source>
        <translation>鼻柱の最も前の点、左右の鼻孔の間の稜。</translation>
    </message>
    <message>
        <source>The foremost point of the nose tip, with the head held upright.</source>
        <translation>頭をまっすぐにしたとき、鼻尖の最も前の点。</translation>
    </message>
    <message>
        <source>The hairline in the middle of the forehead.</source>
        <translation>額の中央の生え際。</translation>
    </message>
    <message>
        <source>The inner corner of the eye, where the lids meet beside the nose.</source>
        <translation>目頭。鼻の横でまぶたが合う所。</translation>
    </message>
    <message>
        <source>The lowest point of the chin in the midline, on its lower border.</source>
        <translation>正中でオトガイ下縁の最も下の点。</translation>
    </message>
    <message>
        <source>The most prominent point of the midline between the eyebrows.</source>
        <translation>左右の眉の間、正中で最も突出した点。</translation>
    </message>
    <message>
        <source>The notch above the tragus, in front of the ear.</source>
        <translation>耳の前、耳珠の上の切れ込み。</translation>
    </message>
    <message>
        <source>The outer corner of the eye, where the lids meet; not the end of the fold beyond.</source>
        <translation>目尻。まぶたが合う所で、その先のしわの端ではない。</translation>
    </message>
    <message>
        <source>The peak of Cupid's bow, at the foot of the ridge beside the groove of the upper lip.</source>
        <translation>人中の稜の下端、キューピッド弓の頂点。</translation>
    </message>
    <message>
        <source>The point of the cheekbone arch that lies furthest to the side.</source>
        <translation>頬骨弓の最も外側の点。</translation>
    </message>
    <message>
        <source>The point of the wing of the nose that lies furthest to the side.</source>
        <translation>鼻翼の最も外側の点。</translation>
    </message>
    <message>
        <source>The temple at the narrowest place of the forehead, at the ridge beside the brow.</source>
        <translation>額の最も狭い所のこめかみ、眉の横の稜。</translation>
    </message>
    <message>
        <source>Toxin: chin</source>
        <translation>毒素：オトガイ</translation>
    </message>
    <message>
        <source>Toxin: crow's feet</source>
        <translation>毒素：目尻のしわ</translation>
    </message>
    <message>
        <source>Toxin: forehead</source>
        <translation>毒素：額</translation>
    </message>
    <message>
        <source>Toxin: frown lines</source>
        <translation>毒素：眉間</translation>
    </message>
    <message>
        <source>Toxin: gummy smile</source>
        <translation>毒素：ガミースマイル</translation>
    </message>
    <message>
        <source>Toxin: masseter</source>
        <translation>毒素：咬筋</translation>
    </message>
    <message>
        <source>Toxin: mouth corner depressor</source>
        <translation>毒素：口角下制筋</translation>
    </message>
    <message>
        <source>Vowel a</source>
        <translation>母音「あ」</translation>
    </message>
    <message>
        <source>Vowel e</source>
        <translation>母音「え」</translation>
    </message>
    <message>
        <source>Vowel i</source>
        <translation>母音「い」</translation>
    </message>
    <message>
        <source>Vowel o</source>
        <translation>母音「お」</translation>
    </message>
    <message>
        <source>Vowel u</source>
        <translation>母音「う」</translation>
    </message>
    <message>
        <source>Where the closed lips meet in the midline; with open lips, halfway between them.</source>
        <translation>正中で閉じた唇が合う所。開いているときはその中間。</translation>
    </message>
    <message>
        <source>Where the columella meets the upper lip: the deepest point of the angle in the midline.</source>
        <translation>鼻柱が上唇に移る所。正中で角の最も深い点。</translation>
    </message>
    <message>
        <source>Where the curved line of the wing begins in the cheek: its hindmost point.</source>
        <translation>鼻翼の曲線が頬から始まる所、最も後ろの点。</translation>
    </message>
    <message>
        <source>Where the wing of the nose runs into the upper lip, below the nostril.</source>
        <translation>鼻孔の下、鼻翼が上唇に移る所。</translation>
    </message>
    <message>
        <source>Zygomaticus major</source>
        <translation>大頬骨筋</translation>
    </message>
    <message>
        <source>Zygomaticus minor</source>
        <translation>小頬骨筋</translation>
    </message>
    <message>
        <source>attachment of the wing</source>
        <translation>鼻翼の付着部</translation>
    </message>
    <message>
        <source>base of the nose</source>
        <translation>鼻の付け根</translation>
    </message>
    <message>
        <source>base of the wing</source>
        <translation>鼻翼の基部</translation>
    </message>
    <message>
        <source>bifrontal width</source>
        <translation>側頭幅</translation>
    </message>
    <message>
        <source>bizygomatic width</source>
        <translation>頬骨弓幅</translation>
    </message>
    <message>
        <source>brow</source>
        <translation>眉</translation>
    </message>
    <message>
        <source>canthal tilt</source>
        <translation>眼裂の傾き</translation>
    </message>
    <message>
        <source>cheek</source>
        <translation>頬</translation>
    </message>
    <message>
        <source>cheekbone arch</source>
        <translation>頬骨弓</translation>
    </message>
    <message>
        <source>chin</source>
        <translation>オトガイ</translation>
    </message>
    <message>
        <source>chin point</source>
        <translation>オトガイ点</translation>
    </message>
    <message>
        <source>chin projection</source>
        <translation>オトガイの突出</translation>
    </message>
    <message>
        <source>chin-lip fold</source>
        <translation>オトガイ唇溝</translation>
    </message>
    <message>
        <source>columella</source>
        <translation>鼻柱</translation>
    </message>
    <message>
        <source>columella length</source>
        <translation>鼻柱長</translation>
    </message>
    <message>
        <source>comparing the sides</source>
        <translation>左右を比較中</translation>
    </message>
    <message>
        <source>cutaneous lower lip height</source>
        <translation>下唇皮膚部の高さ</translation>
    </message>
    <message>
        <source>drawing</source>
        <translation>描画中</translation>
    </message>
    <message>
        <source>ear</source>
        <translation>耳</translation>
    </message>
    <message>
        <source>facial convexity</source>
        <translation>顔面突出角</translation>
    </message>
    <message>
        <source>facial height</source>
        <translation>顔の高さ</translation>
    </message>
    <message>
        <source>forehead</source>
        <translation>額</translation>
    </message>
    <message>
        <source>front</source>
        <translation>正面</translation>
    </message>
    <message>
        <source>glabella</source>
        <translation>眉間</translation>
    </message>
    <message>
        <source>hairline</source>
        <translation>生え際</translation>
    </message>
    <message>
        <source>inner canthal width</source>
        <translation>内眼角間の幅</translation>
    </message>
    <message>
        <source>inner canthus</source>
        <translation>目頭</translation>
    </message>
    <message>
        <source>jaw angle</source>
        <translation>下顎角</translation>
    </message>
    <message>
        <source>jaw line</source>
        <translation>フェイスライン</translation>
    </message>
    <message>
        <source>labial fissure width</source>
        <translation>口裂の幅</translation>
    </message>
    <message>
        <source>lip contact</source>
        <translation>唇の合わせ目</translation>
    </message>
    <message>
        <source>lower lid</source>
        <translation>下まぶた</translation>
    </message>
    <message>
        <source>lower lip</source>
        <translation>下唇</translation>
    </message>
    <message>
        <source>lower lip border</source>
        <translation>下唇の縁</translation>
    </message>
    <message>
        <source>lower lip projection</source>
        <translation>下唇の突出</translation>
    </message>
    <message>
        <source>lower vermilion height</source>
        <translation>下赤唇の高さ</translation>
    </message>
    <message>
        <source>lowest chin point</source>
        <translation>オトガイの最下点</translation>
    </message>
    <message>
        <source>mandibular width</source>
        <translation>下顎角の幅</translation>
    </message>
    <message>
        <source>mouth corner</source>
        <translation>口角</translation>
    </message>
    <message>
        <source>nasal ala length</source>
        <translation>鼻翼の長さ</translation>
    </message>
    <message>
        <source>nasal base projection</source>
        <translation>鼻下点の突出</translation>
    </message>
    <message>
        <source>nasal bridge length</source>
        <translation>鼻背の長さ</translation>
    </message>
    <message>
        <source>nasal height</source>
        <translation>鼻の高さ</translation>
    </message>
    <message>
        <source>nasal protrusion</source>
        <translation>鼻尖の高さ</translation>
    </message>
    <message>
        <source>nasal root</source>
        <translation>鼻根</translation>
    </message>
    <message>
        <source>nasal root depth</source>
        <translation>鼻根の深さ</translation>
    </message>
    <message>
        <source>nasal width</source>
        <translation>鼻翼の幅</translation>
    </message>
    <message>
        <source>nasion</source>
        <translation>ナジオン</translation>
    </message>
    <message>
        <source>nasolabial angle</source>
        <translation>鼻唇角</translation>
    </message>
    <message>
        <source>neck</source>
        <translation>頸部</translation>
    </message>
    <message>
        <source>norm: adults of European descent, 20 to 25 years; band: mean ± 2 sd</source>
        <translation>基準：ヨーロッパ系の成人、20～25 歳。帯：平均 ± 2 SD</translation>
    </message>
    <message>
        <source>nose ala</source>
        <translation>鼻翼</translation>
    </message>
    <message>
        <source>nose dorsum</source>
        <translation>鼻背</translation>
    </message>
    <message>
        <source>nose sidewall</source>
        <translation>鼻側壁</translation>
    </message>
    <message>
        <source>nose tip</source>
        <translation>鼻尖</translation>
    </message>
    <message>
        <source>outer canthal width</source>
        <translation>外眼角間の幅</translation>
    </message>
    <message>
        <source>outer canthus</source>
        <translation>目尻</translation>
    </message>
    <message>
        <source>packing</source>
        <translation>圧縮中</translation>
    </message>
    <message>
        <source>palpebral fissure length</source>
        <translation>瞼裂の長さ</translation>
    </message>
    <message>
        <source>peak of Cupid's bow</source>
        <translation>キューピッド弓の頂点</translation>
    </message>
    <message>
        <source>philtral length</source>
        <translation>人中の長さ</translation>
    </message>
    <message>
        <source>philtral width</source>
        <translation>人中の幅</translation>
    </message>
    <message>
        <source>profile</source>
        <translation>横顔</translation>
    </message>
    <message>
        <source>scalp</source>
        <translation>頭皮</translation>
    </message>
    <message>
        <source>settling</source>
        <translation>形を落ち着かせています</translation>
    </message>
    <message>
        <source>shading</source>
        <translation>陰影を計算中</translation>
    </message>
    <message>
        <source>subnasal width</source>
        <translation>鼻翼基部の幅</translation>
    </message>
    <message>
        <source>temple</source>
        <translation>側頭</translation>
    </message>
    <message>
        <source>three-quarter</source>
        <translation>斜め</translation>
    </message>
    <message>
        <source>tip projection</source>
        <translation>鼻尖の突出</translation>
    </message>
    <message>
        <source>tragus</source>
        <translation>耳珠</translation>
    </message>
    <message>
        <source>upper lid</source>
        <translation>上まぶた</translation>
    </message>
    <message>
        <source>upper lip</source>
        <translation>上唇</translation>
    </message>
    <message>
        <source>upper lip border</source>
        <translation>上唇の縁</translation>
    </message>
    <message>
        <source>upper lip height</source>
        <translation>上唇の高さ</translation>
    </message>
    <message>
        <source>upper lip projection</source>
        <translation>上唇の突出</translation>
    </message>
    <message>
        <source>upper vermilion height</source>
        <translation>上赤唇の高さ</translation>
    </message>
    <message>
        <source>whole face</source>
        <translation>顔全体</translation>
    </message>
    <message>
        <source>wing of the nose</source>
        <translation>鼻翼</translation>
    </message>
    <message>
        <source>writing</source>
        <translation>書き出し中</translation>
    </message>
</context>
<context>
    <name>report</name>
    <message>
        <source>A planning and communication aid, not a medical device. What is shown is an estimate, not a promise of a result.</source>
        <translation>計画と説明のための補助であり、医療機器ではありません。表示は推定であり、結果を約束するものではありません。</translation>
    </message>
    <message>
        <source>Facial simulation</source>
        <translation>顔面シミュレーション</translation>
    </message>
    <message>
        <source>Measures</source>
        <translation>計測値</translation>
    </message>
    <message>
        <source>Notes</source>
        <translation>メモ</translation>
    </message>
    <message>
        <source>The skin moves by up to %1 mm.</source>
        <translation>皮膚の移動は最大 %1 mm です。</translation>
    </message>
    <message>
        <source>What moves</source>
        <translation>動いた所</translation>
    </message>
    <message>
        <source>after</source>
        <translation>後</translation>
    </message>
    <message>
        <source>before</source>
        <translation>前</translation>
    </message>
    <message>
        <source>change</source>
        <translation>変化</translation>
    </message>
</context>
<context>
    <name>sentences</name>
    <message>
        <source>"%1" is damaged.</source>
        <translation>「%1」が壊れています。</translation>
    </message>
    <message>
        <source>"%1" is no text.</source>
        <translation>「%1」がテキストではありません。</translation>
    </message>
    <message>
        <source>"near" is not the name of a landmark.</source>
        <translation>"near" がランドマークの名前ではありません。</translation>
    </message>
    <message>
        <source>%1 %2 is not a number.</source>
        <translation>%1 %2 は数値ではありません。</translation>
    </message>
    <message>
        <source>%1 cannot be unpacked, the case is damaged.</source>
        <translation>%1 を展開できません。症例ファイルが壊れています。</translation>
    </message>
    <message>
        <source>%1 could not make it.</source>
        <translation>%1 で作成できませんでした。</translation>
    </message>
    <message>
        <source>%1 is larger than a case can hold.</source>
        <translation>%1 が症例ファイルの上限を超えています。</translation>
    </message>
    <message>
        <source>%1 is not a finite number.</source>
        <translation>%1 が有限の数値ではありません。</translation>
    </message>
    <message>
        <source>%1 would have to go more than 25 mm.</source>
        <translation>%1 を 25 mm 以上動かす必要があります。</translation>
    </message>
    <message>
        <source>'%1' is an expression of the program: take another name.</source>
        <translation>「%1」はプログラムの表情です。別の名前にしてください。</translation>
    </message>
    <message>
        <source>'%1' is no form of the response; known are %2.</source>
        <translation>「%1」という応答の形はありません。使えるのは %2 です。</translation>
    </message>
    <message>
        <source>'%1' is no place on the scan: give a landmark of its landmark file, "vertex N" or x,y,z.</source>
        <translation>「%1」はスキャン上の位置ではありません。ランドマーク名、"vertex N"、または x,y,z で指定してください。</translation>
    </message>
    <message>
        <source>'%1' is not a measure; known are %2.</source>
        <translation>「%1」という計測項目はありません。使えるのは %2 です。</translation>
    </message>
    <message>
        <source>'%1' is not of the form NAME=NUMBER.</source>
        <translation>「%1」は NAME=NUMBER の形ではありません。</translation>
    </message>
    <message>
        <source>A preset needs a name of at most 60 characters without '='.</source>
        <translation>プリセットの名前は「=」を含まない 60 文字以内にしてください。</translation>
    </message>
    <message>
        <source>A volume lies between -20 and 20 mL and is not 0.</source>
        <translation>体積は −20〜20 mL で、0 以外にしてください。</translation>
    </message>
    <message>
        <source>Cancelled.</source>
        <translation>中止しました。</translation>
    </message>
    <message>
        <source>Drag '%1': force goes with mode=constraint.</source>
        <translation>ドラッグ「%1」：force は mode=constraint のときだけ使えます。</translation>
    </message>
    <message>
        <source>Edges of more than two triangles: %1. Left as they are.</source>
        <translation>3 枚以上の三角形が共有する辺：%1。そのまま残します。</translation>
    </message>
    <message>
        <source>Entries that are neither vertices nor faces: %1. They are not kept in what is written.</source>
        <translation>頂点でも面でもない記述：%1。書き出すファイルには残りません。</translation>
    </message>
    <message>
        <source>It has a place, but the plan does not say on which face it was made ("made_on").</source>
        <translation>位置がありますが、どの顔で作られたか（"made_on"）が計画にありません。</translation>
    </message>
    <message>
        <source>It is a shape without gestures, taken from a variant, which only goes onto the scan it was made on.</source>
        <translation>案から取った形で操作の記録がないため、元のスキャンにしか適用できません。</translation>
    </message>
    <message>
        <source>Its place lies %1 mm beside the skin of this face.</source>
        <translation>位置がこの顔の皮膚から %1 mm 離れています。</translation>
    </message>
    <message>
        <source>Left and right of the landmarks are swapped: _l must be the patient's own left.</source>
        <translation>ランドマークの左右が逆です。_l は患者自身の左でなければなりません。</translation>
    </message>
    <message>
        <source>Loose parts beside the largest one: %1. The face is fitted to the part that holds it; the others are shown and kept.</source>
        <translation>最大の部分のほかに離れた部分：%1。顔を含む部分に適合し、ほかは表示して保持します。</translation>
    </message>
    <message>
        <source>No process can be started for the import (too many open files).</source>
        <translation>読み込み用のプロセスを開始できません（開いているファイルが多すぎます）。</translation>
    </message>
    <message>
        <source>No temporary folder can be made in %1.</source>
        <translation>%1 に一時フォルダーを作れません。</translation>
    </message>
    <message>
        <source>No triangle has any area.</source>
        <translation>面積のある三角形がありません。</translation>
    </message>
    <message>
        <source>Target: %1 stays at %2 of %3: %4</source>
        <translation>目標：%1 は %3 に対し %2 にとどまります：%4</translation>
    </message>
    <message>
        <source>Target: landmarks of %1 are missing on this face.</source>
        <translation>目標：この顔には %1 のランドマークがありません。</translation>
    </message>
    <message>
        <source>Target: nothing of %1 can be moved.</source>
        <translation>目標：%1 に動かせる点がありません。</translation>
    </message>
    <message>
        <source>The age must lie between 3 and 100 years.</source>
        <translation>年齢は 3〜100 歳にしてください。</translation>
    </message>
    <message>
        <source>The asymmetry must lie between 0 and 3 mm.</source>
        <translation>非対称の量は 0〜3 mm にしてください。</translation>
    </message>
    <message>
        <source>The axes '%1' are not a turn: give three signed letters such as +x+y+z or +x-z+y that keep left and right apart.</source>
        <translation>軸「%1」は回転を表しません。左右が入れ替わらない +x+y+z や +x-z+y のような符号付き 3 文字で指定してください。</translation>
    </message>
    <message>
        <source>The contraction of %1 must lie between -0.5 and 1.</source>
        <translation>%1 の収縮は −0.5〜1 にしてください。</translation>
    </message>
    <message>
        <source>The contractions to set belong to another atlas of muscles.</source>
        <translation>設定する収縮は別の筋アトラスのものです。</translation>
    </message>
    <message>
        <source>The face shows too little of forehead and nasal root to lay a result on it.</source>
        <translation>額と鼻根が十分に写っていないため、結果を重ねられません。</translation>
    </message>
    <message>
        <source>The face would be %1 mm wide: give the right unit with --unit.</source>
        <translation>顔の幅が %1 mm になります。正しい単位を指定してください（--unit）。</translation>
    </message>
    <message>
        <source>The faces look inwards. Turned over for computing, kept in the file as they came.</source>
        <translation>面が内向きです。計算では裏返し、ファイルでは元のまま残します。</translation>
    </message>
    <message>
        <source>The kept shape does not belong to this scan.</source>
        <translation>保存された形はこのスキャンのものではありません。</translation>
    </message>
    <message>
        <source>The known distance '%1' is not of the form "from=PLACE; to=PLACE; mm=NUMBER".</source>
        <translation>既知の距離「%1」は "from=PLACE; to=PLACE; mm=NUMBER" の形ではありません。</translation>
    </message>
    <message>
        <source>The landmark %1 lies %2 mm away from the scan: do the landmarks belong to this file, in its own unit?</source>
        <translation>ランドマーク %1 がスキャンから %2 mm 離れています。このファイルのランドマークで、単位は合っていますか？</translation>
    </message>
    <message>
        <source>The landmarks all lie in one place or on one line.</source>
        <translation>ランドマークがすべて 1 か所または 1 直線上にあります。</translation>
    </message>
    <message>
        <source>The landmarks do not lie as on a face: they differ by %1 mm from an average face of the same size and pose.</source>
        <translation>ランドマークの配置が顔らしくありません。同じ大きさと向きの平均顔から %1 mm ずれています。</translation>
    </message>
    <message>
        <source>The landmarks do not suffice: a corner of each eye (en or ex), both mouth corners (ch_l, ch_r) and the nose (prn or sn) are needed.</source>
        <translation>ランドマークが足りません。両目の目頭か目尻 (en または ex)、両口角 (ch_l, ch_r)、鼻 (prn または sn) が必要です。</translation>
    </message>
    <message>
        <source>The midplane needs at least one landmark on both sides.</source>
        <translation>正中面には左右のランドマークが少なくとも 1 組必要です。</translation>
    </message>
    <message>
        <source>The number of vertices must lie between 3000 and 1000000.</source>
        <translation>頂点数は 3000〜1000000 にしてください。</translation>
    </message>
    <message>
        <source>The number of vertices to write differs from the scan's.</source>
        <translation>書き出す頂点数がスキャンと異なります。</translation>
    </message>
    <message>
        <source>The picture's side must lie between 64 and 8192 pixels.</source>
        <translation>画像の一辺は 64〜8192 ピクセルにしてください。</translation>
    </message>
    <message>
        <source>The program's own file %1 is missing; reinstall it or set MYOFACE_DATA to its folder.</source>
        <translation>プログラムのファイル %1 がありません。再インストールするか、MYOFACE_DATA にそのフォルダーを設定してください。</translation>
    </message>
    <message>
        <source>The result does not fit on forehead and nasal root of this face: %1 mm are left. Is it the same patient, and are its unit and landmarks right?</source>
        <translation>結果がこの顔の額と鼻根に合いません（%1 mm の差）。同じ患者ですか？ 単位とランドマークは正しいですか？</translation>
    </message>
    <message>
        <source>The result has no skin opposite the face.</source>
        <translation>結果には、顔に向かい合う皮膚がありません。</translation>
    </message>
    <message>
        <source>The result has too few landmarks in common with the face.</source>
        <translation>結果と顔に共通するランドマークが足りません。</translation>
    </message>
    <message>
        <source>The scan has too few triangles to be a face.</source>
        <translation>スキャンの三角形が少なすぎて、顔とは言えません。</translation>
    </message>
    <message>
        <source>The shape to set does not belong to this face.</source>
        <translation>設定する形はこの顔のものではありません。</translation>
    </message>
    <message>
        <source>The skin's age must lie between 18 and 80 years.</source>
        <translation>皮膚の年齢は 18〜80 歳にしてください。</translation>
    </message>
    <message>
        <source>The strength of %1 must lie between 0 and 1.</source>
        <translation>%1 の筋力は 0〜1 にしてください。</translation>
    </message>
    <message>
        <source>The stubble must lie between 0 and 1.</source>
        <translation>ひげの量は 0〜1 にしてください。</translation>
    </message>
    <message>
        <source>The texture %1 is not beside the file.</source>
        <translation>テクスチャ %1 がファイルの横にありません。</translation>
    </message>
    <message>
        <source>The two places of the known distance are the same.</source>
        <translation>既知の距離の 2 点が同じ位置です。</translation>
    </message>
    <message>
        <source>The unit '%1' is not one of m, dm, cm, mm, in or a number of millimetres.</source>
        <translation>単位「%1」は m、dm、cm、mm、in、またはミリメートル数ではありません。</translation>
    </message>
    <message>
        <source>There is no expression '%1'.</source>
        <translation>「%1」という表情はありません。</translation>
    </message>
    <message>
        <source>There is no expression '%1'; there are %2and action units such as AU12 or AU12.L.</source>
        <translation>「%1」という表情はありません。使えるのは %2と AU12 や AU12.L のような動作単位です。</translation>
    </message>
    <message>
        <source>There is no muscle '%1'; the nearest name is '%2' (with .L or .R for one side).</source>
        <translation>「%1」という筋はありません。近い名前は「%2」です（片側は .L または .R）。</translation>
    </message>
    <message>
        <source>There is no place for temporary files in %1.</source>
        <translation>%1 に一時ファイルを置けません。</translation>
    </message>
    <message>
        <source>There is no preset '%1' of your own.</source>
        <translation>「%1」という自分のプリセットはありません。</translation>
    </message>
    <message>
        <source>There is no tissue depth named '%1': thin, mean or heavy.</source>
        <translation>「%1」という軟組織の厚さはありません：thin、mean、heavy。</translation>
    </message>
    <message>
        <source>There is no vertex %1 (the scan has %2).</source>
        <translation>頂点 %1 はありません（スキャンの頂点は %2 個）。</translation>
    </message>
    <message>
        <source>There is no view '%1': use front, left, right, three-quarter-left, three-quarter-right, below, above or back.</source>
        <translation>「%1」という視点はありません。front、left、right、three-quarter-left、three-quarter-right、below、above、back を使ってください。</translation>
    </message>
    <message>
        <source>There is no weakening '%1'; there are %2, each also with .L or .R.</source>
        <translation>「%1」という筋力低下はありません。使えるのは %2 で、それぞれ .L や .R も付けられます。</translation>
    </message>
    <message>
        <source>This part of the face does not move: choose another place.</source>
        <translation>顔のこの部分は動きません。別の場所を選んでください。</translation>
    </message>
    <message>
        <source>This part of the face is protected: grip beside it.</source>
        <translation>顔のこの部分は保護されています。その横をつかんでください。</translation>
    </message>
    <message>
        <source>This part of the scan does not move: grip the face itself.</source>
        <translation>スキャンのこの部分は動きません。顔をつかんでください。</translation>
    </message>
    <message>
        <source>Too little of a face is left on this scan.</source>
        <translation>このスキャンには顔がほとんど写っていません。</translation>
    </message>
    <message>
        <source>Triangles that repeat another one: %1. Left out of computing, kept in the file.</source>
        <translation>ほかと重複する三角形：%1。計算では除き、ファイルには残します。</translation>
    </message>
    <message>
        <source>Triangles without area: %1. Left out of computing, kept in the file.</source>
        <translation>面積のない三角形：%1。計算では除き、ファイルには残します。</translation>
    </message>
    <message>
        <source>Triangles wound against their neighbours: %1. Turned over for computing, kept in the file as they came.</source>
        <translation>隣と向きが逆の三角形：%1。計算では裏返し、ファイルでは元のまま残します。</translation>
    </message>
    <message>
        <source>Vertices at the place of another one (texture seams): %1. Joined for computing, kept in the file.</source>
        <translation>ほかと同じ位置の頂点（テクスチャの継ぎ目）：%1。計算ではまとめ、ファイルには残します。</translation>
    </message>
    <message>
        <source>Vertices of no triangle with area: %1. Kept in the file.</source>
        <translation>面積のある三角形に属さない頂点：%1。ファイルには残します。</translation>
    </message>
    <message>
        <source>View '%1': the direction has no usable length.</source>
        <translation>視点「%1」：方向の長さが使えません。</translation>
    </message>
    <message>
        <source>What is to be protected does not belong to this face.</source>
        <translation>保護する部分がこの顔のものではありません。</translation>
    </message>
    <message>
        <source>a colour or texture coordinate is not a finite number.</source>
        <translation>色またはテクスチャ座標が有限の数値ではありません。</translation>
    </message>
    <message>
        <source>a contraction is outside -0.5 ... 1.</source>
        <translation>収縮の値が −0.5～1 の範囲外です。</translation>
    </message>
    <message>
        <source>a coordinate is not a finite number.</source>
        <translation>座標が有限の数値ではありません。</translation>
    </message>
    <message>
        <source>a face needs at least three corners.</source>
        <translation>面には少なくとも 3 つの頂点が必要です。</translation>
    </message>
    <message>
        <source>a facet has more than three vertices.</source>
        <translation>4 つ以上の頂点を持つファセットがあります。</translation>
    </message>
    <message>
        <source>a facet needs three vertices, this one has %1.</source>
        <translation>ファセットには 3 つの頂点が必要ですが、%1 個しかありません。</translation>
    </message>
    <message>
        <source>a film is a .gif, an .mp4, or a folder of PNG pictures.</source>
        <translation>動画は .gif、.mp4、または PNG 画像のフォルダーです。</translation>
    </message>
    <message>
        <source>a vertex needs three coordinates.</source>
        <translation>頂点には 3 つの座標が必要です。</translation>
    </message>
    <message>
        <source>a vertex needs three numbers.</source>
        <translation>頂点には 3 つの数値が必要です。</translation>
    </message>
    <message>
        <source>all vertices lie in one place, this is not a face.</source>
        <translation>すべての頂点が 1 か所にあり、顔ではありません。</translation>
    </message>
    <message>
        <source>assets/muscles.json: %1 has no path.</source>
        <translation>assets/muscles.json：%1 に経路がありません。</translation>
    </message>
    <message>
        <source>assets/norms.csv: '%1' is not a number.</source>
        <translation>assets/norms.csv：「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>assets/norms.csv: there is no kind of measure '%1'.</source>
        <translation>assets/norms.csv：「%1」という計測の種類はありません。</translation>
    </message>
    <message>
        <source>assets/tissue_depth.csv: '%1' is not a number.</source>
        <translation>assets/tissue_depth.csv：「%1」は数値ではありません。</translation>
    </message>
    <message>
        <source>cannot be encoded as PNG.</source>
        <translation>PNG に変換できません。</translation>
    </message>
    <message>
        <source>cannot be opened for reading.</source>
        <translation>読み込み用に開けません。</translation>
    </message>
    <message>
        <source>cannot be read to its end.</source>
        <translation>最後まで読み込めません。</translation>
    </message>
    <message>
        <source>cannot be read: the file is damaged or asks for too much memory.</source>
        <translation>読み込めません。ファイルが壊れているか、メモリーを使いすぎます。</translation>
    </message>
    <message>
        <source>cannot be written (%1); is the folder there, writable and not full?</source>
        <translation>書き込めません（%1）。フォルダーがあり、書き込み可能で、空きがあるか確かめてください。</translation>
    </message>
    <message>
        <source>cannot be written.</source>
        <translation>書き込めません。</translation>
    </message>
    <message>
        <source>does not begin with 'ply', this is not a PLY file.</source>
        <translation>'ply' で始まらないため、PLY ファイルではありません。</translation>
    </message>
    <message>
        <source>face %1 %2 does not exist (the file has %3).</source>
        <translation>面の %1 %2 は存在しません（ファイルには %3 個）。</translation>
    </message>
    <message>
        <source>face %1 %2 is not a whole number.</source>
        <translation>面の %1 %2 は整数ではありません。</translation>
    </message>
    <message>
        <source>face %1 0 does not exist (the first one is 1).</source>
        <translation>面の %1 0 は存在しません（最初は 1）。</translation>
    </message>
    <message>
        <source>face %1 names vertex %2, the file has only %3.</source>
        <translation>面 %1 が頂点 %2 を指していますが、ファイルには %3 個しかありません。</translation>
    </message>
    <message>
        <source>face corner ends in %1.</source>
        <translation>面の頂点の記述が %1 で終わっています。</translation>
    </message>
    <message>
        <source>face normal %1 is not a whole number.</source>
        <translation>面の法線 %1 は整数ではありません。</translation>
    </message>
    <message>
        <source>has a coordinate beyond 1e9, this cannot be a face.</source>
        <translation>1e9 を超える座標があり、顔ではありえません。</translation>
    </message>
    <message>
        <source>has more '%1' elements than this program can hold.</source>
        <translation>「%1」の要素がこのプログラムの上限を超えています。</translation>
    </message>
    <message>
        <source>has more than 100000 edits.</source>
        <translation>操作が 100000 を超えています。</translation>
    </message>
    <message>
        <source>has more vertices or corners than this program can hold.</source>
        <translation>頂点または面の頂点数がこのプログラムの上限を超えています。</translation>
    </message>
    <message>
        <source>holds binary data where text is expected (is the file truncated?).</source>
        <translation>テキストのはずの場所にバイナリデータがあります（ファイルが途中で切れていませんか？）。</translation>
    </message>
    <message>
        <source>holds binary data, this is not an OBJ file.</source>
        <translation>バイナリデータを含むため、OBJ ファイルではありません。</translation>
    </message>
    <message>
        <source>holds no "landmarks" object.</source>
        <translation>"landmarks" がありません。</translation>
    </message>
    <message>
        <source>holds no landmark with a known name (prn, en_l, ch_r …).</source>
        <translation>既知の名前のランドマーク (prn, en_l, ch_r …) がありません。</translation>
    </message>
    <message>
        <source>holds no triangles.</source>
        <translation>三角形がありません。</translation>
    </message>
    <message>
        <source>holds no vertices, this is not a face scan.</source>
        <translation>頂点がなく、顔のスキャンではありません。</translation>
    </message>
    <message>
        <source>holds points but no faces; export the scan as a mesh.</source>
        <translation>点だけで面がありません。スキャンをメッシュとして書き出してください。</translation>
    </message>
    <message>
        <source>is empty.</source>
        <translation>空のファイルです。</translation>
    </message>
    <message>
        <source>is larger than this program can hold.</source>
        <translation>このプログラムの上限を超える大きさです。</translation>
    </message>
    <message>
        <source>is neither PNG nor JPEG.</source>
        <translation>PNG でも JPEG でもありません。</translation>
    </message>
    <message>
        <source>is no journal.</source>
        <translation>作業記録ではありません。</translation>
    </message>
    <message>
        <source>is no preset of an expression (%1).</source>
        <translation>表情のプリセットではありません（%1）。</translation>
    </message>
    <message>
        <source>is none of OBJ, PLY, STL, glTF and GLB.</source>
        <translation>OBJ、PLY、STL、glTF、GLB のいずれでもありません。</translation>
    </message>
    <message>
        <source>is none of drag, volume, target, protect and shape, nor a muscle with a rate or strength, nor an expression with an intensity.</source>
        <translation>drag、volume、target、protect、shape のいずれでもなく、rate や strength のある筋でも、intensity のある表情でもありません。</translation>
    </message>
    <message>
        <source>is not a JSON file of landmarks.</source>
        <translation>ランドマークの JSON ファイルではありません。</translation>
    </message>
    <message>
        <source>is not a Myoface case (%1 is missing).</source>
        <translation>Myoface の症例ファイルではありません（%1 がありません）。</translation>
    </message>
    <message>
        <source>is not a Myoface case (it is not a zip archive).</source>
        <translation>Myoface の症例ファイルではありません（zip 形式ではありません）。</translation>
    </message>
    <message>
        <source>is not a plan: a JSON object with a list "plan" is needed.</source>
        <translation>計画ではありません。リスト "plan" を持つ JSON が必要です。</translation>
    </message>
    <message>
        <source>is not a plan: it is not JSON.</source>
        <translation>計画ではありません（JSON ではありません）。</translation>
    </message>
    <message>
        <source>is not a plan: its "format" is another one.</source>
        <translation>計画ではありません（"format" が異なります）。</translation>
    </message>
    <message>
        <source>is not a readable JPEG.</source>
        <translation>読み込める JPEG ではありません。</translation>
    </message>
    <message>
        <source>is not a readable PNG (%1).</source>
        <translation>読み込める PNG ではありません（%1）。</translation>
    </message>
    <message>
        <source>is not a regular file.</source>
        <translation>通常のファイルではありません。</translation>
    </message>
    <message>
        <source>is not an object.</source>
        <translation>オブジェクトではありません。</translation>
    </message>
    <message>
        <source>is protected by a passphrase, which is needed to open it.</source>
        <translation>パスフレーズで保護されており、開くにはそれが必要です。</translation>
    </message>
    <message>
        <source>is protected by another passphrase than this one.</source>
        <translation>別のパスフレーズで保護されています。</translation>
    </message>
    <message>
        <source>is truncated: it promises %1 triangles and holds %2.</source>
        <translation>途中で切れています。三角形 %1 枚のはずが %2 枚しかありません。</translation>
    </message>
    <message>
        <source>is truncated: the header promises %1 '%2' elements, the file is too short for them.</source>
        <translation>途中で切れています。ヘッダーでは「%2」が %1 個ありますが、ファイルが短すぎます。</translation>
    </message>
    <message>
        <source>it is not met after 12 tries.</source>
        <translation>12 回試しても達しません。</translation>
    </message>
    <message>
        <source>its "%1" is not three numbers of millimetres.</source>
        <translation>"%1" がミリメートルの 3 つの数値ではありません。</translation>
    </message>
    <message>
        <source>its "schema" is no whole number from 1.</source>
        <translation>"schema" が 1 以上の整数ではありません。</translation>
    </message>
    <message>
        <source>its manifest has no such schema as %1.</source>
        <translation>目録の版 %1 は存在しません。</translation>
    </message>
    <message>
        <source>its manifest is damaged ("%1" is no text).</source>
        <translation>目録が壊れています（「%1」がテキストではありません）。</translation>
    </message>
    <message>
        <source>its manifest is damaged.</source>
        <translation>目録が壊れています。</translation>
    </message>
    <message>
        <source>its materials are damaged.</source>
        <translation>材質の情報が壊れています。</translation>
    </message>
    <message>
        <source>its place has no triangle: take the place away and write "at=prn" instead.</source>
        <translation>位置に三角形がありません。位置を消して "at=prn" と書いてください。</translation>
    </message>
    <message>
        <source>its place is not on a triangle: weights are not negative and sum to 1.</source>
        <translation>位置が三角形上にありません。重みは負でなく、合計が 1 です。</translation>
    </message>
    <message>
        <source>its settings are damaged.</source>
        <translation>設定が壊れています。</translation>
    </message>
    <message>
        <source>its shape does not move vertices by [number, x, y, z].</source>
        <translation>形が [番号, x, y, z] の形式で頂点を動かしていません。</translation>
    </message>
    <message>
        <source>its shape has an impossible number of vertices.</source>
        <translation>形の頂点数がありえない数です。</translation>
    </message>
    <message>
        <source>its shape is neither "scan" nor {"vertices", "moved"}.</source>
        <translation>形が "scan" でも {"vertices", "moved"} でもありません。</translation>
    </message>
    <message>
        <source>its unit is not one of m, dm, cm, mm, in or a number above 0.</source>
        <translation>単位が m、dm、cm、mm、in、または 0 より大きい数値ではありません。</translation>
    </message>
    <message>
        <source>its unit or axes are damaged.</source>
        <translation>単位または軸の情報が壊れています。</translation>
    </message>
    <message>
        <source>its variants are damaged.</source>
        <translation>案の情報が壊れています。</translation>
    </message>
    <message>
        <source>its vertices have no x, y and z.</source>
        <translation>頂点に x、y、z がありません。</translation>
    </message>
    <message>
        <source>landmark '%1' is not finite.</source>
        <translation>ランドマーク「%1」が有限の数値ではありません。</translation>
    </message>
    <message>
        <source>landmark '%1' is not three numbers.</source>
        <translation>ランドマーク「%1」が 3 つの数値ではありません。</translation>
    </message>
    <message>
        <source>moving %1 further changes nothing.</source>
        <translation>%1 をさらに動かしても変わりません。</translation>
    </message>
    <message>
        <source>no face was found on it; put a landmark file beside it.</source>
        <translation>顔が見つかりませんでした。ランドマークのファイルを横に置いてください。</translation>
    </message>
    <message>
        <source>no face was found on this scan by its shape; give a landmark file with --landmarks, or place the points in the window.</source>
        <translation>このスキャンの形からは顔が見つかりませんでした。ランドマークのファイルを開くか、画面で点を置いてください。</translation>
    </message>
    <message>
        <source>no journal can be kept there%1; changes to this face are safe only once the case is saved.</source>
        <translation>作業記録を残せません%1。この顔の変更は、症例を保存するまで守られません。</translation>
    </message>
    <message>
        <source>no program that makes %1 is installed (%2); give a folder instead, for PNG pictures.</source>
        <translation>%1 を作るプログラム (%2) がありません。代わりにフォルダーを指定すると PNG 画像を書き出します。</translation>
    </message>
    <message>
        <source>none of its landmarks changes it.</source>
        <translation>どの基準点を動かしても変わりません。</translation>
    </message>
    <message>
        <source>reading glTF needs the program myoface-import, which is not installed beside this one.</source>
        <translation>glTF の読み込みに必要な myoface-import がこのプログラムの横にありません。</translation>
    </message>
    <message>
        <source>takes longer to read than %1 seconds; it was given up.</source>
        <translation>読み込みに %1 秒以上かかるため、中断しました。</translation>
    </message>
    <message>
        <source>texture coordinate is not a usable number.</source>
        <translation>テクスチャ座標が使える数値ではありません。</translation>
    </message>
    <message>
        <source>the PLY header counts a list with a number that is not whole.</source>
        <translation>PLY ヘッダーのリスト数が整数ではありません。</translation>
    </message>
    <message>
        <source>the PLY header gives '%1' a second time.</source>
        <translation>PLY ヘッダーに「%1」が 2 回あります。</translation>
    </message>
    <message>
        <source>the PLY header gives no usable count for element %1.</source>
        <translation>PLY ヘッダーの要素 %1 の個数が使えません。</translation>
    </message>
    <message>
        <source>the PLY header has a property before any element.</source>
        <translation>PLY ヘッダーで要素の前にプロパティがあります。</translation>
    </message>
    <message>
        <source>the PLY header has no end (is the file truncated?).</source>
        <translation>PLY ヘッダーに終わりがありません（ファイルが途中で切れていませんか？）。</translation>
    </message>
    <message>
        <source>the PLY header has the element %1 twice.</source>
        <translation>PLY ヘッダーに要素 %1 が 2 回あります。</translation>
    </message>
    <message>
        <source>the PLY header has the property %1 twice.</source>
        <translation>PLY ヘッダーにプロパティ %1 が 2 回あります。</translation>
    </message>
    <message>
        <source>the PLY header names no format.</source>
        <translation>PLY ヘッダーに形式がありません。</translation>
    </message>
    <message>
        <source>the PLY header names the unknown format %1.</source>
        <translation>PLY ヘッダーの形式 %1 は未知です。</translation>
    </message>
    <message>
        <source>the PLY header names the unknown type %1.</source>
        <translation>PLY ヘッダーの型 %1 は未知です。</translation>
    </message>
    <message>
        <source>the bone holds back.</source>
        <translation>骨に当たっています。</translation>
    </message>
    <message>
        <source>the file ends within a facet (is it truncated?).</source>
        <translation>ファセットの途中でファイルが終わっています（途中で切れていませんか？）。</translation>
    </message>
    <message>
        <source>the folder cannot be made.</source>
        <translation>フォルダーを作れません。</translation>
    </message>
    <message>
        <source>the import gave back something that is not a mesh.</source>
        <translation>読み込みの結果がメッシュではありません。</translation>
    </message>
    <message>
        <source>the import program %1 cannot be started.</source>
        <translation>読み込みプログラム %1 を開始できません。</translation>
    </message>
    <message>
        <source>the journal is damaged.</source>
        <translation>作業記録が壊れています。</translation>
    </message>
    <message>
        <source>the picture is larger than 16384 pixels.</source>
        <translation>画像が 16384 ピクセルを超えています。</translation>
    </message>
    <message>
        <source>the setting of %1 is out of range.</source>
        <translation>%1 の設定が範囲外です。</translation>
    </message>
    <message>
        <source>the shape of the skin belongs to a larger scan.</source>
        <translation>皮膚の形が、もっと大きなスキャンのものです。</translation>
    </message>
    <message>
        <source>the shape of the skin is damaged.</source>
        <translation>皮膚の形の情報が壊れています。</translation>
    </message>
    <message>
        <source>the skin there is stretched to its limit.</source>
        <translation>そこの皮膚は限界まで伸びています。</translation>
    </message>
    <message>
        <source>the skin would fold over itself.</source>
        <translation>皮膚が折り重なってしまいます。</translation>
    </message>
    <message>
        <source>the skin's age is out of range.</source>
        <translation>皮膚の年齢が範囲外です。</translation>
    </message>
    <message>
        <source>there is no such file.</source>
        <translation>そのファイルはありません。</translation>
    </message>
    <message>
        <source>this computer's libzip cannot encrypt; save without a passphrase.</source>
        <translation>このコンピューターの libzip は暗号化できません。パスフレーズなしで保存してください。</translation>
    </message>
    <message>
        <source>was written by a newer Myoface; apply it with that one.</source>
        <translation>新しい版の Myoface で書かれています。その版で適用してください。</translation>
    </message>
    <message>
        <source>was written by a newer Myoface; open it with that one.</source>
        <translation>新しい版の Myoface で書かれています。その版で開いてください。</translation>
    </message>
    <message>
        <source>what it protects is out of range.</source>
        <translation>保護部分の情報が範囲外です。</translation>
    </message>
    <message>
        <source>write to a name that ends in .obj, .ply, .stl or .glb.</source>
        <translation>.obj、.ply、.stl、.glb のいずれかで終わる名前で書き出してください。</translation>
    </message>
</context>
</TS>
