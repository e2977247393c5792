// Tables of cylinders, rivers and edges as programs write them, with the right answers by hand.
#include <algorithm>

#include "support/fixtures.hpp"
#include "support/tree_files.hpp"

namespace ramify {
namespace {

// One tree throughout: a trunk of length 2 that forks to 1 and to 3, which forks to 0.5 and 1.5: tips of 1,
// 0.5 and 1.5, an order 2 of 2 + 3.
const char* const fork_answer = "3 2 / 3 1 / 1 5";

TEST(QsmFiles, AreReadAsTheirProgramsWriteThem) {
  const std::string raw =
      "0.2\t2\t0\t0\t0\t0\t0\t1\t0\t3\t1\t0\t1\t0\t0.2\n0.1\t1\t0\t0\t2\t1\t0\t0\t1\t0\t2\t1\t1\t0\t0.1\n"
      "0.15\t3\t0\t0\t2\t0\t0\t1\t1\t4\t1\t0\t2\t0\t0.15\n0.1\t0.5\t0\t0\t5\t1\t0\t0\t3\t0\t3\t1\t1\t0\t0.1\n"
      "0.1\t1.5\t0\t0\t5\t0\t0\t1\t3\t0\t1\t0\t3\t0\t0.1\n";
  const std::string header24 =
      "radius (m)\tlength (m)\tstart_point\taxis_direction\tparent\textension\tbranch\tbranch_order\t"
      "position_in_branch\tmad\tSurfCov\tadded\tUnmodRadius (m)\n";
  const std::string rows24 =
      "0.2\t2\t0\t0\t0\t0\t0\t1\t0\t3\t1\t0\t1\t0\t1\t0\t0.2\n0."
      "1\t1\t0\t0\t2\t1\t0\t0\t1\t0\t2\t1\t1\t0\t1\t0\t0.1\n"
      "0.15\t3\t0\t0\t2\t0\t0\t1\t1\t4\t1\t0\t2\t0\t1\t0\t0.15\n0.1\t0."
      "5\t0\t0\t5\t1\t0\t0\t3\t0\t3\t1\t1\t0\t1\t0\t0.1\n"
      "0.1\t1.5\t0\t0\t5\t0\t0\t1\t3\t0\t1\t0\t3\t0\t1\t0\t0.1\n";
  test::expect_answers({
      {"TreeQSM 2.3 save_model_text", raw, fork_answer},
      {"TreeQSM 2.4 save_model_text: points below one name", header24 + rows24, fork_answer},
      {"TreeQSM 2.4 without its header", rows24, fork_answer},
      {"TreeQSM by MATLAB dlmwrite, commas",
       [&] {
         std::string text = raw;
         std::ranges::replace(text, '\t', ',');
         return text;
       }(),
       fork_answer},
      {"rTwig",
       "id,parent,start_x,start_y,start_z,length,radius,branch\n1,0,0,0,0,2,.2,1\n2,1,0,0,2,1,.1,2\n3,1,0,0,"
       "2,3,.15,1\n"
       "4,3,0,0,5,.5,.1,3\n5,3,0,0,5,1.5,.1,1\n",
       fork_answer},
      {"SimpleForest, ids from 0",
       "ID,parentID,startX,radius,length\n0,-1,0,.2,2\n1,0,0,.1,1\n2,0,0,.1,3\n3,2,0,.1,.5\n4,2,0,.1,1.5\n",
       fork_answer},
      {"SimpleForest, blanks and semicolons",
       "ID ; parentID ; radius ; length\n0 ; -1 ; 0.2 ; 2\n1 ; 0 ; 0.1 ; 1\n2 ; 0 ; 0.1 ; 3\n"
       "3 ; 2 ; 0.1 ; 0.5\n4 ; 2 ; 0.1 ; 1.5\n",
       fork_answer},
      {"aRchi",
       "cyl_ID\tparent_ID\tradius_cyl\tlength\n1\t0\t.2\t2\n2\t1\t.1\t1\n3\t1\t.1\t3\n4\t3\t.1\t.5\n5\t3\t."
       "1\t1.5\n",
       fork_answer},
      {"aRchi, TreeQSM's columns under its names",
       "radius,length,startX,startY,startZ,axisX,axisY,axisZ,parent,extension\n"
       ".2,2,0,0,0,0,0,1,0,3\n.1,1,0,0,2,1,0,0,1,0\n.1,3,0,0,2,0,0,1,1,4\n.1,.5,0,0,5,1,0,0,3,0\n.1,1.5,0,0,"
       "5,0,0,1,3,0\n",
       fork_answer},
      {"R write.csv: row names",
       "\"\",\"id\",\"parent\",\"radius\",\"length\"\n\"1\",1,NA,.2,2\n\"2\",2,1,.1,1\n\"3\",3,1,.1,3\n\"4\","
       "4,3,.1,.5\n\"5\",5,3,.1,1.5\n",
       fork_answer},
      {"R write.table: a header one field short",
       "\"id\" \"parent\" \"radius\" \"length\"\n\"1\" 1 NA .2 2\n\"2\" 2 1 .1 1\n\"3\" 3 1 .1 3\n\"4\" 4 3 "
       ".1 .5\n\"5\" 5 3 .1 1.5\n",
       fork_answer},
      {"R write.csv2: decimal commas",
       "\"id\";\"parent\";\"radius\";\"length\"\n1;NA;0,2;2\n2;1;0,1;1\n3;1;0,1;3\n4;3;0,1;0,5\n5;3;0,1;1,"
       "5\n",
       fork_answer},
      {"pandas: parents as floats",
       "id,parent,radius,length\n1,,0.2,2.0\n2,1.0,0.1,1.0\n3,1.0,0.1,3.0\n4,3.0,0.1,0.5\n5,3.0,0.1,1.5\n",
       fork_answer},
      {"pandas: an index without a name",
       ",id,parent,radius,length\n0,1,0,0.2,2\n1,2,1,0.1,1\n2,3,1,0.1,3\n3,4,3,0.1,0.5\n4,5,3,0.1,1.5\n",
       fork_answer},
      {"R with large ids",
       "id,parent,radius,length\n1e+05,NA,.2,2\n100001,1e+05,.1,1\n100002,1e+05,.1,3\n100003,100002,.1,."
       "5\n100004,100002,.1,1.5\n",
       fork_answer},
      {"units in brackets",
       "id,parent,radius [cm],Length [m]\n1,0,20,2\n2,1,10,1\n3,1,10,3\n4,3,10,.5\n5,3,10,1.5\n",
       fork_answer},
      {"diameters in place of radii",
       "id,parent,diameter_cm,length_m\n1,0,20,2\n2,1,10,1\n3,1,10,3\n4,3,10,.5\n5,3,10,1.5\n", fork_answer},
      {"thousands: 2,000 and 500 mm",
       "id;parent;radius;length\n1;0;100.5;2,000\n2;1;10;1,000\n3;1;10;3,000\n4;3;10;500\n5;3;10;1,500\n",
       "3 2 / 3 1 / 1000 5000"},
      {"thousands that may be decimals", "id;parent;radius;length\n1;0;100;2,000\n",
       "refused: its mark may part thousands or decimals"},
      {"old line ends", "id,parent,radius,length\r1,0,.2,2\r2,1,.1,1\r3,1,.1,3\r4,3,.1,.5\r5,3,.1,1.5",
       fork_answer},
      {"an empty column at the end",
       "id,parent,radius,length,\n1,0,.2,2,\n2,1,.1,1,\n3,1,.1,3,\n4,3,.1,.5,\n5,3,.1,1.5,\n,,,,\n",
       fork_answer},
      {"a byte-order mark",
       "\xEF\xBB\xBFid,parent,radius,length\n1,0,.2,2\n2,1,.1,1\n3,1,.1,3\n4,3,.1,.5\n5,3,.1,1.5\n",
       fork_answer},
      {"two trees, their rows mixed",
       "tree,id,parent,radius,length\na,1,0,1,2\nb,1,0,1,9\na,2,1,1,1\nb,2,1,1,5\na,3,1,1,3\nb,3,1,1,7\na,4,"
       "3,1,.5\na,5,3,1,1.5\n",
       "3 2 / 3 1 / 1 5; 2 1 / 2 1 / 6 9"},
      {"two trees, one with two roots", "tree,id,parent,radius,length\na,1,0,1,2\nb,1,0,1,9\nb,2,0,1,5\n",
       "refused: f:4:3: tree b: 2 roots, among them 1 and 2"},
      {"a cylinder twice", "id,parent,radius,length\n1,0,1,1\n2,1,1,1\n2,1,1,1\n",
       "refused: both rows have the same parent: one is doubled"},
      {"a negative length", "id,parent,radius,length\n1,0,1,-1\n", "refused: f:2:7: length = -1"},
  });
}

TEST(RiverFiles, AreReadAsTheirProgramsWriteThem) {
  test::expect_answers({
      {"hydroloom", "id,toid,length_km\n1,0,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n", fork_answer},
      {"NHDPlusV2", "COMID,GNIS_NAME,LENGTHKM,ToCOMID\n1,A,2,0\n2,,1,1\n3,A,3,1\n4,,.5,3\n5,,1.5,3\n",
       fork_answer},
      {"NHDPlusV2, Hydroseq",
       "COMID,LENGTHKM,Hydroseq,DnHydroseq\n71,2,1,0\n72,1,2,1\n73,3,3,1\n74,.5,4,3\n75,1.5,5,3\n",
       fork_answer},
      {"nhdplusTools, floats",
       "nhdplusid,tonhdplusid,lengthkm\n1.0,0.0,2\n2.0,1.0,1\n3.0,1.0,3\n4.0,3.0,.5\n5.0,3.0,1.5\n",
       fork_answer},
      {"NHDPlus HR, ids of 14 digits in R's writing",
       "nhdplusid,tonhdplusid,lengthkm\n2.2000400023951e+13,0,2\n22000400023952,2.2000400023951e+13,1\n"
       "22000400023953,22000400023951,3\n22000400023954,22000400023953,.5\n22000400023955,22000400023953,1."
       "5\n",
       fork_answer},
      {"HydroRIVERS",
       "HYRIV_ID,NEXT_DOWN,MAIN_RIV,LENGTH_KM,ORD_STRA\n1,0,1,2,2\n2,1,1,1,1\n3,1,1,3,2\n4,3,1,.5,1\n5,3,1,1."
       "5,1\n",
       fork_answer},
      {"HydroBASINS", "HYBAS_ID,NEXT_DOWN,NEXT_SINK,SUB_AREA\n1,0,1,9\n2,1,1,9\n3,1,1,9\n4,3,1,9\n5,3,1,9\n",
       "3 2 / 3 1"},
      {"MERIT Basins",
       "COMID,lengthkm,order,NextDownID,maxup,up1,up2\n1,2,2,0,2,2,3\n2,1,1,1,0,0,0\n3,3,2,1,2,4,5\n4,.5,1,3,"
       "0,0,0\n5,1.5,1,3,0,0,0\n",
       fork_answer},
      {"TauDEM",
       "LINKNO DSLINKNO USLINKNO1 USLINKNO2 strmOrder Length\n1 -1 2 3 2 2\n2 1 -1 -1 1 1\n3 1 4 5 2 3\n4 3 "
       "-1 -1 1 .5\n5 3 -1 -1 1 1.5\n",
       fork_answer},
      {"TauDEM, links from 0", "LINKNO,DSLINKNO,Length\n0,-1,2\n1,0,1\n2,0,3\n3,2,.5\n4,2,1.5\n",
       fork_answer},
      {"GRASS r.stream.order by v.db.select",
       "cat|next_stream|strahler|length\n1|-1|2|2\n2|1|1|1\n3|1|2|3\n4|3|1|.5\n5|3|1|1.5\n", fork_answer},
      {"GRASS r.stream.order by v.db.select separator=comma",
       "cat,stream,next_stream,prev_str01,prev_str02,strahler,length\n1,1,-1,2,3,2,2\n2,2,1,0,0,1,1\n"
       "3,3,1,4,5,2,3\n4,4,3,0,0,1,.5\n5,5,3,0,0,1,1.5\n",
       fork_answer},
      {"openSTARS",
       "stream,prev_str01,prev_str02,next_str,Length\n1,2,3,-1,2\n2,0,0,1,1\n3,4,5,1,3\n4,0,0,3,.5\n5,0,0,3,"
       "1.5\n",
       fork_answer},
      {"nextgen hydrofabric, ids with words",
       "id,toid,lengthkm\nwb-1,nex-9,2\nwb-2,wb-1,1\nwb-3,wb-1,3\nwb-4,wb-3,.5\nwb-5,wb-3,1.5\n",
       fork_answer,
       {"wb-1", 0}},
      {"SWORD", "reach_id,rch_id_dn,reach_length\n1,,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n", fork_answer},
      {"ArcGIS StreamToFeature",
       "ARCID,FROM_NODE,TO_NODE,length_m\n1,11,10,2\n2,12,11,1\n3,13,11,3\n4,14,13,.5\n5,15,13,1.5\n",
       fork_answer},
      {"an outlet that drains to itself", "id,toid,lengthkm\n1,1,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n",
       fork_answer},
      {"an outlet NA, R", "\"id\",\"toid\",\"lengthkm\"\n1,NA,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n",
       fork_answer},
      {"rows doubled by a join",
       "id,toid,lengthkm,gage\n1,0,2,a\n1,0,2,b\n2,1,1,\n3,1,3,\n4,3,.5,\n4,3,.5,\n5,3,1.5,\n", fork_answer},
      {"rows doubled with other lengths", "id,toid,lengthkm\n1,0,2\n2,1,1\n2,1,4\n",
       "refused: both rows have the same parent: one is doubled"},
      {"a river that parts again", "id,toid\n1,0\n2,1\n3,1\n4,2\n4,3\n",
       "refused: a river that parts again is not a tree"},
      {"a loop elsewhere, a root chosen",
       "id,toid,lengthkm\n1,0,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n8,9,1\n9,8,1\n",
       fork_answer,
       {"1", 0}},
      {"a loop elsewhere, no root chosen", "id,toid\n1,0\n8,9\n9,8\n", "refused: a cycle of 2 nodes"},
      {"a loop, its own node chosen", "id,toid\n1,0\n8,9\n9,8\n", "refused: a cycle of 2 nodes", {"8", 0}},
      {"a clipped map", "id,toid,lengthkm\n1,77,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n",
       "refused: parent 77 of node 1 has no row"},
      {"a clipped map, its outlet chosen, another spelling",
       "id,toid,lengthkm\n1,77,2\n2,1,1\n3,1,3\n4,3,.5\n5,3,1.5\n",
       fork_answer,
       {"1.0", 0}},
      {"lengths of 0", "id,toid,lengthkm\n1,0,2\n2,1,0\n3,1,0\n", "2 1 / 2 1 / 0 2"},
      {"a semicolon table with decimal commas",
       "ID;TOID;LENGTHKM\n1;0;2,0\n2;1;1,0\n3;1;3,0\n4;3;0,5\n5;3;1,5\n", fork_answer},
  });
}

TEST(EdgeFiles, AreReadAsTheirProgramsWriteThem) {
  test::expect_answers({
      {"tidytree as_tibble: the root is its own parent",
       "parent,node,branch.length,label\n4,1,1,a\n5,2,.5,b\n5,3,1.5,c\n4,4,2,NA\n4,5,3,NA\n", fork_answer},
      {"phylobase print: ancestor 0",
       "label,node,ancestor,edge.length,node.type\na,1,4,1,tip\nb,2,5,.5,tip\nc,3,5,1.5,tip\n<NA>,4,0,2,"
       "root\n<NA>,5,4,3,internal\n",
       fork_answer},
      {"ape as.data.frame(tree$edge)", "V1,V2,edge.length\n4,1,1\n4,5,3\n5,2,.5\n5,3,1.5\n",
       "3 2 / 3 1 / 1 3"},
      {"igraph, networkx: from and to", "from,to,length\nt,a,1\nt,b,3\nb,c,.5\nb,d,1.5\n", "3 2 / 3 1 / 1 3"},
      {"a missing parent in every way", "id,parent\n1,<NA>\n2,1\n3,1\n", "2 1 / 2 1"},
      {"N/A", "id,parent\n1,N/A\n2,1\n3,1\n", "2 1 / 2 1"},
      {"-1.0", "id,parent\n1,-1.0\n2,1\n3,1\n", "2 1 / 2 1"},
      {"0 is a node where it has a row", "id,parent\n0,-1\n1,0\n2,0\n", "2 1 / 2 1"},
      {"a commented header", "# id parent\n1 0\n2 1\n3 1\n", "2 1 / 2 1"},
      {"no header: parent, child", "1 2\n1 3\n", "2 1 / 2 1"},
      {"ids in two spellings", "id,parent\n1,0\n01,1\n",
       "refused: f:3:1: ids 01 and 1 (line 2) are one number"},
      {"1.0 and 1 as two nodes", "id,parent\n1,0\n1.0,1\n", "refused: ids 1.0 and 1 (line 2) are one number"},
      {"two self-parents", "id,parent\n1,1\n2,2\n", "refused: 2 roots"},
      {"a self-parent beside a root", "id,parent\n1,0\n2,2\n", "refused: f:3:1: node 2 is its own parent"},
  });
}

TEST(TableFiles, WhatIsNotReadIsSaid) {
  EXPECT_EQ(test::remarks_of("id,parent,colour,state\n1,0,a,b\n"), "f: ignored: columns colour, state\n");
  EXPECT_EQ(test::remarks_of("id,toid\n1,0\n2,1\n9,7\n", {"1", 0}), "f: ignored: 1 row not below 1\n");
  EXPECT_EQ(test::remarks_of("id,toid\n1,0\n2,1\n2,1\n"),
            "f: ignored: 1 row that doubles another (same id, same end)\n");
  EXPECT_EQ(test::remarks_of("id,parent,a,b,c,d,e,f,g,h,i,j\n1,0,,,,,,,,,,\n"),
            "f: ignored: columns a, b, c, d, e, f, g, h and 2 more\n");
  EXPECT_EQ(test::remarks_of("id,parent\n1,0\n"), "");
  EXPECT_EQ(test::remarks_of("id,parent,length\n1,0,\n2,1,NA\n3,1,4\n"), "f: a node is without a length\n");
}

}  // namespace
}  // namespace ramify
